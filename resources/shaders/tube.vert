// A round tube of uSides + 1 vertices a node, the last one on the first; or the ridge that stands for it, of four.

uniform int uSides;
uniform float uPlies;
uniform float uTwist;              // radians of the plies' pattern per mm
uniform float uDetail;             // 0 .. 1: how much of the plies is shown

out float vAngle;                  // around the yarn; of the ridge in its middle
#ifdef RIDGE
out float vSide;                   // -1 .. 1 from outline to outline
vec3 vOutwards;
#else
out vec3 vOutwards;
#endif
#ifdef CUT
out vec3 vPlace;
#endif

// The yarn is less wide at the grooves between the plies.
float widthAt(float angle) {
    if (uDetail <= 0.0 || uPlies < 1.5) return 1.0;
    float groove = 0.5 - 0.5 * cos(uPlies * angle - uTwist * vArc);
    return 1.0 - uDetail * 0.40 / uPlies * groove * groove;
}

void main() {
    int ring = gl_VertexID / (uSides + 1);
    int corner = gl_VertexID - ring * (uSides + 1);
    Node node = readNode(ring * uStride);
    vec3 first = normalize(node.reference - dot(node.reference, vTangent) * vTangent);
    vec3 second = cross(vTangent, first);
#ifdef RIDGE
    vec3 across = cross(vTangent, node.toViewer) / vSlope;
    vec3 ridge = cross(across, vTangent);
    vSide = corner == 1 ? 0.0 : corner == 2 ? 1.0 : -1.0;   // the side behind is never seen
    vOutwards = corner == 1 ? ridge : vSide * across;
    // The angle runs on from node to node: on the side of the fabric that is seen it is far from where it jumps.
    float front = node.facing < 0.0 ? -1.0 : 1.0;
    vAngle = atan(front * dot(ridge, second), front * dot(ridge, first)) + (front < 0.0 ? 3.14159265 : 0.0);
    float radius = uRadius * widthAt(vAngle + vSide * 1.57079633);
    // Straight from outline to ridge as much light as on the half circle in between.
    vOpen = openTo(node, corner == 1 ? ridge : vOutwards + 0.57 * ridge, node.height + (corner == 1 ? 0.5 : 0.285));
#else
    vAngle = 6.28318531 * float(corner) / float(uSides);
    float turn = corner == uSides ? 0.0 : vAngle;   // exactly, so that the seam is tight
    vOutwards = cos(turn) * first + sin(turn) * second;
    // Between the circles inside and around the polygon, so that the yarn looks as wide as it is.
    float radius = uRadius * widthAt(vAngle) * 2.0 / (1.0 + cos(3.14159265 / float(uSides)));
    vOpen = openTo(node, vOutwards, node.height + 0.5 * dot(vOutwards, node.normal));
#endif
    // Inside a bend narrower than the yarn the tube would fold over itself.
    radius = min(radius, 0.92 / max(dot(vOutwards, node.bend), 1e-6));
    if (node.isEnd) radius *= 0.3;
    vec4 place = vec4(node.place + radius * vOutwards, 1.0);
#ifdef CUT
    vPlace = place.xyz;
#endif
    gl_ClipDistance[0] = dot(uCut, place);
    gl_Position = uProjection * (uView * place);
}

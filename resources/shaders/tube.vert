// A round tube. uSides + 1 vertices a node, the last one on the first.

uniform int uSides;

out vec3 vOutwards;
out float vAngle;                  // around the yarn
#ifdef CUT
out vec3 vPlace;
#endif

void main() {
    int ring = gl_VertexID / (uSides + 1);
    int corner = gl_VertexID - ring * (uSides + 1);
    Node node = readNode(ring * uStride);
    vAngle = 6.28318531 * float(corner) / float(uSides);
    // Between the circles inside and around the polygon, so that the yarn looks as wide as it is.
    float radius = uRadius * 2.0 / (1.0 + cos(3.14159265 / float(uSides)));
    if (uSides == 3) {
        // Far away: outline, ridge towards the viewer, outline; the side behind is never seen.
        vec3 across = cross(vTangent, node.toViewer) / vSlope;
        vOutwards = corner == 1 ? cross(across, vTangent) : corner == 2 ? across : -across;
        radius = uRadius;
    } else {
        vec3 first = normalize(node.reference - dot(node.reference, vTangent) * vTangent);
        float turn = corner == uSides ? 0.0 : vAngle;   // exactly, so that the seam is tight
        vOutwards = cos(turn) * first + sin(turn) * cross(vTangent, first);
    }
    vDepth = node.height + (uSides == 3 ? kMeanHeight : 0.5 * dot(vOutwards, node.normal));
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

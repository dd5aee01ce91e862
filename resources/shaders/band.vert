// A flat band that faces the viewer. Two vertices a node: gl_VertexID / 2 counts the nodes, the lowest bit the edge.

out vec3 vAcross;
out float vSide;                   // -1 .. 1 across the band
out float vViewZ;

void main() {
    Node node = readNode((gl_VertexID >> 1) * uStride);
    vSide = float(gl_VertexID & 1) * 2.0 - 1.0;
    vec3 across = cross(vTangent, node.toViewer);
    float length2 = dot(across, across);
    vAcross = length2 > 1e-6 ? across * inversesqrt(length2) : node.reference;
    // As much light as on the half circle on the whole.
    vOpen = openTo(node, 0.6 * vSide * vAcross + 0.785 * cross(vAcross, vTangent), node.height + kMeanHeight);
    // Inside a bend narrower than the yarn the band would fold over itself.
    float radius = min(uRadius, 0.92 / max(dot(vSide * vAcross, node.bend), 1e-6));
    vec4 place = vec4(node.place + radius * (vSide * vAcross + kTowardsRidge * cross(vAcross, vTangent)), 1.0);
    gl_ClipDistance[0] = dot(uCut, place);
    vec4 seen = uView * place;
    vViewZ = seen.z;
    gl_Position = uProjection * seen;
}

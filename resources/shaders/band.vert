// A flat band that faces the viewer. Two vertices a node: gl_VertexID / 2 is the node, the lowest bit the edge.

out vec3 vAcross;
out float vSide;
out float vSlope;                  // sine of the angle between yarn and line of sight
out float vViewZ;

void main() {
    vec3 reference;
    bool isEnd;
    vec3 place = readNode(gl_VertexID >> 1, reference, isEnd);
    vSide = float(gl_VertexID & 1) * 2.0 - 1.0;
    vec3 across = cross(vTangent, vToViewer);
    vSlope = length(across);
    vAcross = vSlope > 1e-3 ? across / vSlope : reference;
    vec4 seen = uView * vec4(place + vSide * uRadius * vAcross, 1.0);
    vViewZ = seen.z;
    gl_Position = uProjection * seen;
}

// A round tube. uSides + 1 vertices a node, the last one on the first.

uniform int uSides;

out vec3 vOutwards;
out float vAngle;                  // around the yarn

void main() {
    int node = gl_VertexID / (uSides + 1);
    int corner = gl_VertexID - node * (uSides + 1);
    vec3 reference;
    bool isEnd;
    vec3 place = readNode(node, reference, isEnd);
    vec3 first = normalize(reference - dot(reference, vTangent) * vTangent);
    vAngle = 6.28318531 * float(corner) / float(uSides);
    float turn = corner == uSides ? 0.0 : vAngle;   // exactly, so that the seam is tight
    vOutwards = cos(turn) * first + sin(turn) * cross(vTangent, first);
    // Between the circles inside and around the polygon, so that the yarn looks as wide as it is.
    float radius = uRadius * 2.0 / (1.0 + cos(3.14159265 / float(uSides)));
    if (isEnd) radius *= 0.3;
    gl_Position = uProjection * (uView * vec4(place + radius * vOutwards, 1.0));
}

// Loose fibres that stand off the yarn: one line strip an instance, uHairs of them a node.

uniform int uFirst;          // node
uniform int uHairs;
uniform float uHair;         // 0 .. 1
uniform float uGrown;        // 0 .. 1: they grow as the yarn comes nearer
uniform vec3 uKey;           // unit, to the light
uniform float uSegmentMm;    // between two nodes

out float vLight;

const float kLast = 3.0;     // vertices of a strip, less one

uint seed;

// 0 .. 1; the same fibre always gets the same numbers.
float chance() {
    seed = seed * 747796405u + 2891336453u;
    uint word = ((seed >> ((seed >> 28u) + 4u)) ^ seed) * 277803737u;
    return float(((word >> 22u) ^ word) & 1023u) / 1023.0;
}

void main() {
    int index = uFirst + gl_InstanceID / uHairs;
    Node node = readNode(index);
    seed = uint(index * uHairs + gl_InstanceID % uHairs) * 2654435761u + 12345u;
    chance();
    float angle = 6.28318531 * chance();
    float share = chance();
    float reach = uRadius * (0.12 + 0.75 * uHair) * (0.25 + share * share) * uGrown;
    float lean = 3.2 * (chance() - 0.5);
    float curl = 2.6 * (chance() - 0.5);
    float t = float(gl_VertexID) / kLast;
    angle += curl * t * (0.4 + uHair);
    vec3 first = normalize(node.reference - dot(node.reference, vTangent) * vTangent);
    vec3 outwards = cos(angle) * first + sin(angle) * cross(vTangent, first);
    // It leaves the yarn flat and bends away.
    float off = reach * t * (0.45 + 0.55 * t);
    vec3 place = node.place + (0.97 * uRadius + off) * outwards +
                 (uSegmentMm * (chance() - 0.5) + lean * reach * t) * vTangent;
    vDepth = node.height + 0.5 * dot(outwards, node.normal);
    vLight = (0.45 + 0.55 * dot(outwards, uKey)) * smoothstep(-1.1, 0.7, vDepth) + 0.25 * t;
    vec4 there = vec4(place, 1.0);
    gl_ClipDistance[0] = dot(uCut, there);
    gl_Position = uProjection * (uView * there);
}

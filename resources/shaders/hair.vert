// Loose fibres that stand off the yarn: one line strip an instance, anywhere on a piece.

uniform int uFirst;          // node
uniform int uPieceNodes;     // of the piece
uniform float uHair;         // 0 .. 1
uniform float uGrown;        // 0 .. 1: they grow as the yarn comes nearer
uniform vec3 uKey;           // unit, to the light
uniform float uSegmentMm;    // between two nodes
uniform float uPixelMm;
uniform float uCover;        // of a pixel, where it is thickest

out float vLight;
out float vCover;            // of a pixel

const float kLast = 5.0;     // vertices of a strip, less one
const float kWideMm = 0.02;  // of a fibre

uint seed;

// 0 .. 1; the same fibre always gets the same numbers.
float chance() {
    seed = seed * 747796405u + 2891336453u;
    uint word = ((seed >> ((seed >> 28u) + 4u)) ^ seed) * 277803737u;
    return float(((word >> 22u) ^ word) & 1023u) / 1023.0;
}

void main() {
    // The more there are, the same ones are the first.
    seed = uint(uFirst) * 2654435761u + uint(gl_InstanceID) * 40503u + 12345u;
    chance();
    Node node = readNode(uFirst + min(int(chance() * float(uPieceNodes)), uPieceNodes - 1));
    float angle = 6.28318531 * chance();
    float share = chance();
    float far = share * share * share;        // most stay near, a few stand off
    float reach = uRadius * (0.10 + 0.25 * uHair + far * (0.15 + 0.75 * uHair)) * uGrown;
    float along = (chance() < 0.5 ? -1.0 : 1.0) * uRadius * (0.5 + 1.3 * chance());
    float curl = 1.6 * (chance() - 0.5);
    float back = 0.3 + 0.7 * chance();        // how far it bends back to the yarn
    float t = float(gl_VertexID) / kLast;
    angle += curl * t;
    vec3 first = normalize(node.reference - dot(node.reference, vTangent) * vTangent);
    vec3 outwards = cos(angle) * first + sin(angle) * cross(vTangent, first);
    // It leaves the yarn flat, rises and bends back.
    float off = reach * (2.0 * t - (1.0 + back) * t * t) * 1.2;
    vec3 place = node.place + (0.94 * uRadius + off) * outwards +
                 (uSegmentMm * (chance() - 0.5) + along * t * (1.0 - 0.25 * t)) * vTangent;
    vOpen = openTo(node, outwards, node.height + 0.5 * dot(outwards, node.normal));
    // Light shines through: they are never quite dark.
    vLight = (1.05 + 0.40 * dot(outwards, uKey)) * (0.45 + 0.55 * vOpen);
    vCover = min(1.0, kWideMm / uPixelMm) * smoothstep(0.0, 0.25, t) * (1.0 - t * t) * uCover;
    vec4 there = vec4(place, 1.0);
    gl_ClipDistance[0] = dot(uCut, there);
    gl_Position = uProjection * (uView * there);
}

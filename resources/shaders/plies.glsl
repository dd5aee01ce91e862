// Plies and fibres of a yarn seen near by.

uniform float uPlies;
uniform float uTwist;        // radians of the plies' pattern per mm
uniform float uHelix;        // tangent of the plies' angle to the yarn
uniform float uMelange;
uniform float uDetail;       // 0 .. 1: fades in as the yarn comes nearer
uniform float uRadius;
uniform sampler2D uNoise;

uniform vec3 uBetween;       // unit, between light and viewer

struct Fibres {
    vec3 normal;
    float relief;            // shade of the grooves
    float tint;              // factor of the colour
    float strand;            // 0 .. 2: single fibres, darker and brighter
    float shine;             // 0 .. 1: light along the fibres' cone
};

Fibres findFibres(Surface surface) {
    vec3 around = cross(vTangent, surface.normal);
    // From the crest of a ply, -1 .. 1 at the grooves beside it.
    float turn = (uPlies * surface.angle - uTwist * vArc) * 0.159155;
    float ply = floor(turn + 0.5);
    float aside = uPlies > 1.5 ? 2.0 * (turn - ply) : 0.0;
    float square = aside * aside;
    // Every ply is round: from its crest the surface falls away to a narrow groove, where little light comes.
    float relief = 1.0 - 0.72 * uDetail * square * square * square;
    float tilt = uDetail * aside * (0.45 + 0.75 * square);
    vec3 normal = normalize(surface.normal + tilt * (around - uHelix * vTangent));
    // Spinning turns the fibres of a ply against the twist of the plies: outside they lie nearly along the yarn.
    float along = 0.045 * vArc / uRadius + 0.37 * ply;
    vec2 noise = texture(uNoise, vec2(along, 0.159155 * surface.angle - 0.3 * along)).rg - 0.5;
    float bend = 0.25 * uHelix + uDetail * noise.x;
    float askew = dot(vTangent + bend * around, uBetween);
    return Fibres(normal, relief, 1.0 + uMelange * (1.2 * noise.y + 0.8 * noise.x), 1.0 + 1.6 * uDetail * noise.x,
                  max(0.0, 1.0 - askew * askew / (1.0 + bend * bend)));
}

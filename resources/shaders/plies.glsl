// Plies and fibres of a yarn seen near by.

uniform float uPlies;
uniform float uTwist;        // radians of the plies' pattern per mm
uniform float uHelix;        // tangent of the fibres' angle to the yarn
uniform float uMelange;
uniform float uDetail;       // 0 .. 1: fades in as the yarn comes nearer
uniform float uRadius;
uniform sampler2D uNoise;

struct Fibres {
    vec3 normal;
    float relief;            // shade of the grooves
    float tint;              // factor of the colour
    float shine;             // 0 .. 1, to the sixteenth power: light along the fibres' cone
};

Fibres findFibres(Surface surface, vec3 between) {
    vec3 around = cross(vTangent, surface.normal);
    float phase = uPlies * surface.angle - uTwist * vArc;
    float plied = uPlies > 1.5 ? uDetail : 0.0;
    // Every ply is round: from its crest the surface falls away to a narrow groove, where little light comes.
    float crest = cos(phase);
    float relief = mix(1.0, mix(0.26, 1.04, smoothstep(-1.02, -0.55, crest)), plied);
    float tilt = 0.62 * sin(phase) * (1.25 - 0.55 * crest);
    vec3 normal = normalize(surface.normal + plied * tilt * (around - uHelix * vTangent));
    float turns = surface.angle - uTwist * vArc / max(uPlies, 1.0);
    float strand = texture(uNoise, vec2(0.05 * vArc / uRadius, 0.1592 * turns)).r - 0.5;
    float spot = texture(uNoise, vec2(0.021 * vArc, 0.37)).g - 0.5;
    vec3 fibre = vTangent + uHelix * around;
    float along = dot(fibre, between);
    float shine = max(0.0, 1.0 - along * along / dot(fibre, fibre));
    return Fibres(normal, relief * (1.0 + 0.95 * uDetail * strand), 1.0 + uMelange * (1.3 * spot + 0.7 * strand), shine);
}

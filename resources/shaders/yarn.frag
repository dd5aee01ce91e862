// Lit, plied yarn.

uniform vec3 uColour;        // linear
uniform vec3 uAccent;
uniform vec3 uKey;           // unit, to the light
uniform vec3 uFill;
uniform vec3 uSky;           // unit, upwards on the screen
uniform float uPlies;
uniform float uTwist;        // radians of the plies' pattern per mm
uniform float uHelix;        // tangent of the fibres' angle to the yarn
uniform float uHair;
uniform float uGloss;
uniform float uMelange;
uniform float uDetail;       // 0 far away .. 1 near
uniform sampler2D uNoise;

void main() {
    Surface surface = findSurface();
    vec3 normal = surface.normal;

    // How far this place lies below the fabric's face, in diameters: deep places get little light.
    float depth = vHeight + 0.5 * dot(normal, vNormal);
    float open = smoothstep(-0.95, 0.85, depth);
    float edge = mix(0.40, 1.0, smoothstep(0.0, 0.75, surface.round));

    vec3 colour = uColour;
    float relief = 1.0;
    vec3 around = cross(vTangent, normal);
    vec3 fibre = vTangent + uHelix * around;
    if (uDetail > 0.0) {
        float phase = uPlies * surface.angle - uTwist * vArc;
        float plied = uPlies > 1.5 ? uDetail : 0.0;
        relief = mix(1.0, mix(0.55, 1.04, smoothstep(-1.0, -0.45, cos(phase))), plied);
        normal = normalize(normal + 0.45 * plied * sin(phase) * (around - uHelix * vTangent));
        float turns = surface.angle - uTwist * vArc / max(uPlies, 1.0);
        float strand = texture(uNoise, vec2(0.05 * vArc / uRadius, 0.1592 * turns)).r;
        relief *= 1.0 + uDetail * 0.50 * (strand - 0.5);
        float tint = texture(uNoise, vec2(0.021 * vArc, 0.37)).g;
        colour *= 1.0 + uMelange * (1.3 * (tint - 0.5) + 1.2 * (strand - 0.5));
    }

    float key = max(0.0, (dot(normal, uKey) + 0.22) / 1.22);
    float fill = max(0.0, (dot(normal, uFill) + 0.4) / 1.4);
    float sky = 0.5 + 0.5 * dot(normal, uSky);
    vec3 light = vec3(1.02, 0.99, 0.94) * (1.14 * key * mix(0.06, 1.0, open) * edge) +
                 vec3(0.80, 0.88, 1.0) * (0.20 * fill + 0.20 + 0.16 * sky) * mix(0.14, 1.0, open * edge);

    vec3 between = normalize(uKey + vToViewer);
    float along = dot(fibre, between);
    float shine = max(0.0, 1.0 - along * along / dot(fibre, fibre));
    shine *= shine; shine *= shine; shine *= shine; shine *= shine;
    float glint = (0.05 + 0.50 * uGloss) * shine * key * open * surface.round;
    float rim = 1.0 - surface.round;
    float sheen = uHair * 0.30 * rim * rim * open;

    vec3 lit = 0.84 * colour * relief * light + vec3(glint * relief) + sheen * (0.6 * colour + 0.1);
    lit = mix(lit, uAccent * uAccent * (0.30 + 0.80 * key) * relief, 0.80 * vState.x + 0.40 * vState.y);
    oColour = vec4(sqrt(clamp(lit, 0.0, 1.0)), 1.0);
}

// Three strokes in one: wide and dark, narrower in the yarn's colour, thin bright dots along the middle.

uniform vec3 uColour;        // as shown
uniform vec3 uAccent;
uniform float uDotMm;        // from dot to dot

void main() {
    Surface surface = findSurface();
    float soft = clamp(fwidth(surface.side), 0.0, 0.4);
    float open = smoothstep(-1.1, 0.6, vHeight + 0.5 * surface.round);
    vec3 body = mix(uColour, uAccent, 0.85 * vState.x + 0.45 * vState.y) * mix(0.55, 1.0, open);
    vec3 dark = body * 0.22;
    vec3 bright = mix(body, vec3(1.0), 0.72);
    float along = abs(fract(vArc / uDotMm) - 0.5);
    float softAlong = clamp(fwidth(vArc / uDotMm), 0.0, 1.0);
    float dotted = smoothstep(0.0, max(softAlong, 0.05), 0.28 - along) *
                   (1.0 - smoothstep(0.16 - soft, 0.16 + soft, surface.side)) *
                   clamp(1.5 - 2.0 * softAlong, 0.0, 1.0);
    vec3 colour = mix(body, dark, smoothstep(0.66 - soft, 0.66 + soft, surface.side));
    oColour = vec4(mix(colour, bright, dotted), 1.0);
}

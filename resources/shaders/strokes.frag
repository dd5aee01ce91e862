// Three strokes in one: wide and dark, narrower in the yarn's colour, thin bright dots along the middle.

uniform vec2 uWidths;        // of body and dots, diameters of the yarn
uniform vec2 uDots;          // from dot to dot, mm; length of a dot as a share of that
uniform vec2 uShares;        // of the colour in the dark stroke and in a dot
uniform float uSoft;         // one pixel in yarn radii

void main() {
    Surface surface = findSurface();
    float side = sqrt(1.0 - surface.round * surface.round);
    vec3 body = vColour * (0.55 + 0.45 * vOpen);
    float along = abs(fract(vArc / uDots.x) - 0.5);
    float softAlong = uSoft * 0.7;
    float dotted = smoothstep(0.0, softAlong + 0.05, 0.5 * uDots.y - along) *
                   (1.0 - smoothstep(uWidths.y - uSoft, uWidths.y + uSoft, side)) * clamp(1.6 - 2.0 * softAlong, 0.0, 1.0);
    vec3 colour = body * mix(1.0, uShares.x, smoothstep(uWidths.x - uSoft, uWidths.x + uSoft, side));
    oColour = vec4(mix(colour, mix(vec3(1.0), body, uShares.y), dotted), 1.0);
}

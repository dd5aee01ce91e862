// Three strokes in one: wide and dark, narrower in the yarn's colour, thin bright dots along the middle.

uniform vec3 uColour;        // as shown
uniform vec3 uAccent;
uniform float uDotMm;        // from dot to dot
uniform float uSoft;         // one pixel in yarn radii

void main() {
    Surface surface = findSurface();
    float side = sqrt(1.0 - surface.round * surface.round);
    float open = smoothstep(-0.9, 0.8, vDepth);
    vec3 body = mix(colourHere(uColour), uAccent, 0.85 * vGlow) * (0.55 + 0.45 * open);
    float along = abs(fract(vArc / uDotMm) - 0.5);
    float softAlong = uSoft * 0.7;
    float dotted = smoothstep(0.0, softAlong + 0.05, 0.28 - along) *
                   (1.0 - smoothstep(0.16 - uSoft, 0.16 + uSoft, side)) * clamp(1.6 - 2.0 * softAlong, 0.0, 1.0);
    vec3 colour = body * (1.0 - 0.78 * smoothstep(0.54 - uSoft, 0.54 + uSoft, side));
    oColour = vec4(mix(colour, 0.28 * body + 0.72, dotted), 1.0);
}

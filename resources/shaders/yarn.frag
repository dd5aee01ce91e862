// Lit yarn.

uniform vec3 uColour;        // linear
uniform vec3 uAccent;        // linear
uniform vec3 uKey;           // unit, to the light
uniform vec3 uBetween;       // unit, between light and viewer
uniform vec3 uFill;
uniform vec3 uSky;           // unit, upwards on the screen
uniform float uHair;
uniform float uGloss;

// What of the light reaches a place that is open so far. What yarn around it throws back has its colour: shadows of
// bright yarn are lighter and warm, not grey.
vec3 reach(float open, vec3 own) { return open / (1.0 - 0.6 * (1.0 - open) * own); }

void main() {
#ifdef CUT
    if (!gl_FrontFacing) {
        vec3 cut = mix(mix(colourHere(uColour), vec3(1.0), 0.3), uAccent, 0.8 * vGlow) * cutFace();
        oColour = vec4(sqrt(clamp(cut, 0.0, 1.0)), 1.0);
        return;
    }
#endif
    Surface surface = findSurface();
    Fibres fibres = findFibres(surface, uBetween);

    // Deep places and the creases between yarns get little light.
    float open = smoothstep(-0.80, 1.00, vDepth);
    float edge = 0.22 + 0.78 * smoothstep(0.0, 0.85, surface.round);
    float key = max(0.0, dot(fibres.normal, uKey) * 0.82 + 0.18);
    float fill = max(0.0, dot(fibres.normal, uFill) * 0.71 + 0.29);
    float sky = 0.28 + 0.08 * dot(fibres.normal, uSky);
    vec3 own = colourHere(uColour);
    vec3 shade = reach(open * edge * fibres.relief, own);
    vec3 light = vec3(0.977, 0.948, 0.900) * (key * (0.06 * edge + 0.94 * shade)) +
                 vec3(0.672, 0.739, 0.840) * ((0.20 * fill + sky) * (0.14 + 0.86 * shade));

    float shine = fibres.shine;
    shine *= shine; shine *= shine; shine *= shine; shine *= shine;
    float rim = 1.0 - surface.round;
    float glint = (0.05 + 0.50 * uGloss) * shine * key * open * surface.round * fibres.relief + uHair * 0.03 * rim * rim * open;
    vec3 colour = own * (fibres.tint + uHair * 0.18 * rim * rim * open);
    if (uByValue) {
        // White light and shallow shadows: the colour is to be read.
        colour = own;
        light = vec3(0.45 + 0.55 * dot(light, vec3(0.333)));
        glint = 0.0;
    }
    vec3 lit = colour * light + glint;
    lit = mix(lit, uAccent * (0.30 + 0.80 * key) * fibres.relief, 0.80 * vGlow);
    oColour = vec4(sqrt(clamp(lit, 0.0, 1.0)), 1.0);
}

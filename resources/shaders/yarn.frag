// Lit yarn.

uniform vec3 uKey;           // unit, to the light
uniform vec3 uAmbient;       // to where the light from all around is brightest, as long as it differs
uniform float uHair;
uniform float uGloss;
uniform bool uByValue;       // the colour tells a value

// What of the light reaches a place that is open so far. What yarn around it throws back has its colour: shadows of
// bright yarn are lighter and warm, not grey.
vec3 reach(float open, vec3 own) { return open + 0.75 * open * (1.0 - open) * own; }

void main() {
#ifdef CUT
    if (!gl_FrontFacing) {
        oColour = vec4(sqrt(clamp(mix(vColour, vec3(1.0), 0.3) * cutFace(), 0.0, 1.0)), 1.0);
        return;
    }
#endif
    Surface surface = findSurface();
    Fibres fibres = findFibres(surface);

    float open = vOpen * (0.55 + 0.45 * surface.round) * fibres.relief;
    // Fibres scatter light beyond the edge of the shadow.
    float key = max(0.0, dot(fibres.normal, uKey) * 0.62 + 0.38);
    vec3 shade = reach(open, vColour);
    vec3 light = vec3(1.123, 1.090, 1.035) * key * shade +
                 vec3(0.672, 0.739, 0.840) * ((0.388 + dot(fibres.normal, uAmbient)) * (0.08 + 0.92 * shade));

    // Light along the cone of the fibres: narrow on silk, wide and weak on wool.
    float shine = fibres.shine;
    shine *= shine; shine *= shine;
    float narrow = shine * shine; narrow *= narrow;
    float rim = 1.0 - surface.round;
    float glint = (0.03 * shine + 0.5 * uGloss * uGloss * narrow) * key * open * surface.round * fibres.strand;
    vec3 colour = vColour * (fibres.tint * (0.45 + 0.55 * fibres.strand) + uHair * 0.25 * rim * rim);
    if (uByValue) {
        // White light and shallow shadows: the colour is to be read.
        colour = vColour;
        light = vec3(0.45 + 0.55 * dot(light, vec3(0.333)));
        glint = 0.0;
    }
    oColour = vec4(sqrt(clamp(colour * light + glint, 0.0, 1.0)), 1.0);
}

// A loose fibre.

uniform vec3 uColour;        // linear

in float vLight;

void main() {
    vec3 colour = colourHere(uColour) * (0.25 + 0.95 * vLight) + 0.02;
    oColour = vec4(sqrt(clamp(colour, 0.0, 1.0)), 1.0);
}

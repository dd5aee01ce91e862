// A loose fibre, thinner than a pixel: it covers a part of it.

in float vLight;
in float vCover;

void main() {
    vec3 colour = vColour * vLight + 0.02;
    // Weighed with its cover: so it is added to the picture, see drawHair.
    oColour = vec4(sqrt(clamp(colour, 0.0, 1.0)), 1.0) * vCover;
}

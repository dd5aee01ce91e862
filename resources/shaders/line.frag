uniform vec3 uColour;
uniform vec3 uAccent;

void main() {
    findSurface();
    oColour = vec4(mix(colourHere(uColour), uAccent, vGlow), 1.0);
}

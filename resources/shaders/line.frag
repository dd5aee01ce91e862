uniform vec3 uColour;
uniform vec3 uAccent;

void main() {
    findSurface();
    oColour = vec4(mix(uColour, uAccent, vState.x + 0.5 * vState.y), 1.0);
}

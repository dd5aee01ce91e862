void main() {
    findSurface();
    oColour = vec4(vColour, 1.0);
}

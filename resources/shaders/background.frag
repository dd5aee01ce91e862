uniform vec3 uLower;
uniform vec3 uUpper;

in float vUp;
out vec4 oColour;

void main() { oColour = vec4(mix(uLower, uUpper, vUp), 1.0); }

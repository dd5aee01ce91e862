// What the fragment shaders of yarns know of the place they colour.

uniform vec3 uToViewer;      // unit, in the middle of the picture

in vec3 vTangent;
in float vArc;
in float vDepth;
in float vSlope;
in float vGlow;
in float vValue;

uniform bool uByValue;       // the colour tells a value
uniform vec3 uRamp[7];       // from low to high

out vec4 oColour;

struct Surface {
    vec3 normal;    // unit
    float round;    // 0 at the yarn's outline, 1 in its middle
    float angle;    // around the yarn
};

vec3 colourHere(vec3 own) {
    if (!uByValue) return own;
    float place = 6.0 * clamp(vValue, 0.0, 1.0);
    int i = min(int(place), 5);
    return mix(uRamp[i], uRamp[i + 1], place - float(i));
}

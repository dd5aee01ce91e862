// What the fragment shaders of yarns know of the place they colour.

uniform vec3 uToViewer;      // unit, in the middle of the picture

in vec3 vTangent;
in float vArc;
in float vOpen;
in float vSlope;
in vec3 vColour;

out vec4 oColour;

struct Surface {
    vec3 normal;    // unit
    float round;    // 0 at the yarn's outline, 1 in its middle
    float angle;    // around the yarn
};

// What the fragment shaders of yarns know of the place they colour.

uniform mat4 uProjection;
uniform float uRadius;

in vec3 vTangent;
in vec3 vNormal;
in vec3 vToViewer;
in float vArc;
in float vHeight;
in vec2 vState;

out vec4 oColour;

struct Surface {
    vec3 normal;    // unit
    float round;    // 0 at the yarn's outline, 1 in its middle
    float side;     // 0 in the middle, 1 at the outline
    float angle;    // around the yarn
};

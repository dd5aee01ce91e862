layout(location = 0) in vec3 aPlace;
layout(location = 1) in uint aKind;

uniform mat4 uView;
uniform mat4 uProjection;
uniform float uSize;         // pixels

flat out uint vKind;

void main() {
    vKind = aKind;
    vec4 place = uView * vec4(aPlace, 1.0);
    gl_Position = uProjection * place;
    gl_Position.z -= 1e-4 * gl_Position.w;
    gl_PointSize = aKind == 2u ? 1.5 * uSize : uSize;
}

layout(location = 0) in vec3 aPlace;
layout(location = 1) in uint aKind;
layout(location = 2) in vec3 aFront;
layout(location = 3) in vec3 aBehind;

uniform mat4 uView;
uniform mat4 uProjection;
uniform vec4 uCut;           // what lies where its product with a place is negative is cut away
uniform vec3 uToViewer;
uniform float uSize;         // pixels
uniform float uLift;         // mm towards the viewer, so that lines end below the marker

flat out uint vKind;
flat out vec2 vWay;          // crossing: of the strand nearer to the viewer, on the screen; 0 when seen end on
flat out float vPixels;

void main() {
    vKind = aKind;
    gl_ClipDistance[0] = dot(uCut, vec4(aPlace, 1.0));
    vec4 place = uView * vec4(aPlace, 1.0);
    place.z += uLift;
    gl_Position = uProjection * place;
    vPixels = aKind == 2u ? 2.0 * uSize : uSize;
    gl_PointSize = vPixels;
    vec3 way = mat3(uView) * (uToViewer.z < 0.0 ? aBehind : aFront);
    float onScreen = length(way.xy);
    vWay = onScreen > 0.2 * length(way) ? vec2(way.x, -way.y) / onScreen : vec2(0.0);
}

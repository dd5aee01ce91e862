// Bonding points by role: a foot in a head (disc in a ring), an open head (ring), a crossing (the strand in
// front goes on, the one behind is interrupted).

uniform vec3 uFoot;
uniform vec3 uHead;
uniform vec3 uCrossing;
uniform vec3 uLower;         // of the background
uniform vec3 uUpper;
uniform float uHeight;       // of the picture, pixels; 0: no background
uniform float uBottom;       // of the framebuffer in the picture, pixels

flat in uint vKind;
flat in vec2 vWay;
flat in float vPixels;
out vec4 oColour;

// How much of the pixel lies inside, for a signed distance in radii of the marker.
float cover(float inside) { return clamp(0.5 * vPixels * inside + 0.5, 0.0, 1.0); }

vec4 ground() {
    return uHeight > 0.0 ? vec4(mix(uLower, uUpper, (gl_FragCoord.y + uBottom) / uHeight), 1.0) : vec4(0.0);
}

void show(vec3 colour, float alpha) {
    if (alpha < (uHeight > 0.0 ? 0.02 : 0.5)) discard;
    oColour = vec4(colour, uHeight > 0.0 ? alpha : 1.0);
}

void main() {
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    float r = length(p);
    float rim = 1.0 - 1.0 / vPixels;     // keeps the soft edge inside the square
    if (vKind == 0u) {
        show(mix(uHead, uFoot, cover(0.62 - r)), cover(rim - r));
    } else if (vKind == 1u) {
        show(uHead, min(cover(rim - r), cover(r - 0.5)));
    } else {
        float bar = vWay == vec2(0.0) ? cover(0.5 - r)
                                      : min(cover(rim - r), cover(0.26 - abs(p.x * vWay.y - p.y * vWay.x)));
        // A gap as soon as there is room for one.
        float gap = smoothstep(9.0, 14.0, vPixels) * 0.62;
        if (bar < 0.5 && r < gap) {
            oColour = ground();
            return;
        }
        show(uCrossing, bar);
    }
}

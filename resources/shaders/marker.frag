// Bonding points by role: drawn through (round), open head (ring), crossing (cross).

uniform vec3 uColours[3];

flat in uint vKind;
out vec4 oColour;

void main() {
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    float r = length(p);
    float inside = vKind == 0u ? 1.0 - r
                 : vKind == 1u ? min(1.0 - r, r - 0.5)
                               : min(1.0 - r, 0.22 - min(abs(p.x - p.y), abs(p.x + p.y)) * 0.7071);
    if (inside < 0.0) discard;
    oColour = vec4(uColours[vKind], 1.0);
}

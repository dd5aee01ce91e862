// The face of a cut yarn. Through the cut one sees the inside of the tube, and only there; it gets the colour of the
// place where the line of sight meets the plane.

uniform vec4 uCut;           // the plane
uniform vec4 uViewer;        // eye (w = 1) or direction to a viewer far away (w = 0)

in vec3 vPlace;

const float kPi = 3.14159265;

// Grain of cut fibres, and the grooves between the plies, which turn along the yarn as they do outside.
float cutFace() {
    vec3 sight = uViewer.w > 0.5 ? normalize(vPlace - uViewer.xyz) : -uViewer.xyz;
    vec3 seen = vPlace - sight * dot(uCut, vec4(vPlace, 1.0)) / max(dot(uCut.xyz, sight), 1e-3);
    vec2 place = vec2(seen.x + 0.6 * seen.z, seen.y - 0.7 * seen.z);
    float grain = 0.80 + 0.35 * texture(uNoise, 0.7 / uRadius * place).g;
    if (uPlies < 1.5 || uDetail <= 0.0) return grain;

    // From the middle of the yarn to there, in radii: along, outwards where the line of sight leaves, and across both.
    vec3 along = normalize(vTangent);
    vec3 outwards = normalize(vOutwards - dot(vOutwards, along) * along);
    vec3 off = (seen - vPlace) / uRadius + outwards;
    float x = dot(off, outwards);
    float y = dot(off, cross(along, outwards));
    float arc = vArc + uRadius * dot(off, along);
    float radius = min(1.0, length(vec2(x, y)));
    float phase = uPlies * (vAngle + (radius > 1e-3 ? atan(y, x) : 0.0)) - uTwist * arc;
    float fromCrest = abs(mod(phase + kPi, 2.0 * kPi) - kPi) / uPlies;
    float toGroove = radius * sin(kPi / uPlies - fromCrest);
    float groove = 1.0 - smoothstep(0.03, 0.08 + 0.16 * radius * radius, toGroove);
    float rim = smoothstep(0.75, 1.0, radius);
    return grain * (1.0 - uDetail * (0.62 * groove + 0.18 * rim));
}

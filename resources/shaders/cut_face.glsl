// The face of a cut yarn. Through the cut one sees the inside of the tube, and only there; it gets the colour of the
// place where the line of sight meets the plane.

uniform vec4 uCut;           // the plane
uniform vec4 uViewer;        // eye (w = 1) or direction to a viewer far away (w = 0)

in vec3 vPlace;

// Grain of cut fibres.
float cutFace() {
    vec3 sight = uViewer.w > 0.5 ? normalize(vPlace - uViewer.xyz) : -uViewer.xyz;
    vec3 seen = vPlace - sight * dot(uCut, vec4(vPlace, 1.0)) / max(dot(uCut.xyz, sight), 1e-3);
    vec2 place = vec2(seen.x + 0.6 * seen.z, seen.y - 0.7 * seen.z);
    return 0.80 + 0.35 * texture(uNoise, 0.7 / uRadius * place).g;
}

// A yarn too far away to show its plies: what they do on the whole is less round and less light.

uniform vec3 uBetween;       // unit, between light and viewer

struct Fibres {
    vec3 normal;
    float relief;
    float tint;
    float strand;
    float shine;
};

Fibres findFibres(Surface surface) {
    float askew = dot(vTangent, uBetween);
    return Fibres(normalize(surface.normal + 0.25 * uToViewer), 0.9, 1.0, 1.0, max(0.0, 1.0 - askew * askew));
}

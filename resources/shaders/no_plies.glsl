// A yarn too far away to show its plies.

struct Fibres {
    vec3 normal;
    float relief;
    float tint;
    float shine;
};

Fibres findFibres(Surface surface, vec3 between) {
    float shine = dot(surface.normal, between);
    return Fibres(surface.normal, 0.97, 1.0, shine * shine);
}

// A yarn too far away to show its plies; its fibres shine as they do near by.

uniform float uHelix;        // tangent of the fibres' angle to the yarn

struct Fibres {
    vec3 normal;
    float relief;
    float tint;
    float shine;
};

Fibres findFibres(Surface surface, vec3 between) {
    vec3 fibre = vTangent + uHelix * cross(vTangent, surface.normal);
    float along = dot(fibre, between);
    float shine = max(0.0, 1.0 - along * along / dot(fibre, fibre));
    return Fibres(surface.normal, 1.0, 1.0, shine);
}

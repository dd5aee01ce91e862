in vec3 vOutwards;
in float vAngle;

Surface findSurface() {
    vec3 normal = normalize(vOutwards);
    vec3 across = cross(vTangent, vToViewer);
    float side = min(1.0, abs(dot(normal, across)) * inversesqrt(max(dot(across, across), 1e-6)));
    return Surface(normal, sqrt(1.0 - side * side), side, vAngle);
}

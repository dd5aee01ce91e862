in vec3 vOutwards;
in float vAngle;

Surface findSurface() {
    vec3 normal = vOutwards * inversesqrt(dot(vOutwards, vOutwards));
    return Surface(normal, clamp(dot(normal, uToViewer) / vSlope, 0.0, 1.0), vAngle);
}

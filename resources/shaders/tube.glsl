// A round tube, or the ridge that stands for it.

in float vAngle;
#ifdef RIDGE
in float vSide;                    // -1 .. 1 from outline to outline

Surface findSurface() {
    // Across the ridge the normal turns as on the tube.
    vec3 ridge = normalize(uToViewer - dot(uToViewer, vTangent) * vTangent);
    float square = vSide * vSide;
    float round = sqrt(max(0.0, 1.0 - square));
    float angle = vAngle + vSide * (1.0 + square * (0.10 + 0.47 * square * square));   // nearly the arc sine
    return Surface(vSide * cross(vTangent, ridge) + round * ridge, round, angle);
}
#else
in vec3 vOutwards;

Surface findSurface() {
    vec3 normal = vOutwards * inversesqrt(dot(vOutwards, vOutwards));
    return Surface(normal, clamp(dot(normal, uToViewer) / vSlope, 0.0, 1.0), vAngle);
}
#endif

uniform int uSides;

in vec3 vOutwards;
in float vAngle;

// Two flat faces stand for the half of a round tube that is seen: across them the normal turns as on the tube.
vec3 normalOnRidge() {
    vec3 ridge = normalize(uToViewer - dot(uToViewer, vTangent) * vTangent);
    vec3 aside = vOutwards - dot(vOutwards, ridge) * ridge;
    return aside + sqrt(max(0.0, 1.0 - dot(aside, aside))) * ridge;
}

Surface findSurface() {
#ifdef ROUND
    vec3 normal = vOutwards * inversesqrt(dot(vOutwards, vOutwards));
#else
    vec3 normal = uSides == 3 ? normalOnRidge() : vOutwards * inversesqrt(dot(vOutwards, vOutwards));
#endif
    return Surface(normal, clamp(dot(normal, uToViewer) / vSlope, 0.0, 1.0), vAngle);
}

// The band stands for a round yarn: its normals and its depth are those of the tube.

in vec3 vAcross;
in float vSide;
in float vSlope;
in float vViewZ;

Surface findSurface() {
    float round = sqrt(max(0.0, 1.0 - vSide * vSide));
    float z = vViewZ + uRadius * round / max(vSlope, 0.4);
    float depth = (uProjection[2][2] * z + uProjection[3][2]) / (uProjection[2][3] * z + uProjection[3][3]);
    gl_FragDepth = 0.5 * depth + 0.5;
    return Surface(vSide * vAcross + round * cross(vAcross, vTangent), round, abs(vSide), 0.0);
}

// The band stands for a round yarn: its normals and its depth are those of the tube.

uniform mat4 uProjection;
uniform float uRadius;

in vec3 vAcross;
in float vSide;
in float vViewZ;

Surface findSurface() {
    float round = sqrt(max(0.0, 1.0 - vSide * vSide));
    float z = vViewZ + uRadius * round;
    float depth = (uProjection[2][2] * z + uProjection[3][2]) / (uProjection[2][3] * z + uProjection[3][3]);
    gl_FragDepth = 0.5 * depth + 0.5;
    return Surface(vSide * vAcross + round * uToViewer, round, 0.0);
}

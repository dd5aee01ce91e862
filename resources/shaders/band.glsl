// The band stands for a round yarn: its normals and its depth are those of the tube.

uniform mat4 uProjection;
uniform float uRadius;

in vec3 vAcross;
in float vSide;
in float vViewZ;

Surface findSurface() {
    float round = sqrt(max(0.0, 1.0 - vSide * vSide));
    // The band lies between the yarn's middle and the ridge of its side that is seen.
    float slope = max(vSlope, 0.25);
    float z = vViewZ + uRadius * ((1.0 - kTowardsRidge) * round / slope - kTowardsRidge * slope * (1.0 - round));
    float depth = (uProjection[2][2] * z + uProjection[3][2]) / (uProjection[2][3] * z + uProjection[3][3]);
    gl_FragDepth = 0.5 * depth + 0.5;
    return Surface(vSide * vAcross + round * cross(vAcross, vTangent), round, 0.0);
}

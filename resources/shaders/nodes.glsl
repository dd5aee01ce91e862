// Nodes of yarns, as the vertex shaders read them, and what the fragment shaders get of them. Few outputs: a software
// driver pays for each of them at every pixel.

uniform samplerBuffer uNodes;      // x y z, arc length (mm)
uniform usamplerBuffer uSurface;   // direction across and height, fabric normal and value; packed
uniform usamplerBuffer uOwner;     // bonding point
uniform usamplerBuffer uState;     // by bonding point: 0 plain, 1 selected, 2 hovered
uniform mat4 uView;
uniform mat4 uProjection;
uniform vec4 uCut;                 // what lies where its product with a place is negative is cut away
uniform vec4 uViewer;              // eye (w = 1) or direction to a viewer far away (w = 0)
uniform float uRadius;             // mm
uniform bool uAnyState;
uniform int uStride;               // only every so many nodes are drawn

out vec3 vTangent;
out float vArc;                    // mm
out float vDepth;                  // diameters over the fabric's middle, towards the viewer
out float vSlope;                  // sine of the angle between yarn and line of sight
out float vGlow;                   // 1 selected, 0.5 hovered, 0
out float vValue;                  // 0 to 1: what the colour tells

const float kMeanHeight = 0.393;   // of the side of a round yarn that is seen over its middle, in diameters

struct Node {
    vec3 place;
    vec3 reference;                // a direction across the yarn that turns with it
    vec3 toViewer;
    vec3 normal;                   // of the fabric, on the viewer's side
    float height;                  // diameters over the fabric's middle, towards the viewer
    vec3 bend;                     // curvature, 1/mm, towards the inside of the bend
    bool isEnd;
};

vec3 unpackDirection(uint bits) {
    vec2 p = vec2(float(bits & 2047u), float((bits >> 11) & 2047u)) / 1023.0 - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) {
        n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    }
    return normalize(n);
}

// Fills the outputs that do not depend on the vertex around the node.
Node readNode(int index) {
    vec4 here = texelFetch(uNodes, index);
    vec4 before = texelFetch(uNodes, max(index - 1, 0));
    vec4 after = texelFetch(uNodes, min(index + 1, textureSize(uNodes) - 1));
    // Arc length rises along a yarn; it is negative between two yarns.
    bool isFirst = before.w < 0.0 || before.w >= here.w;
    bool isLast = after.w <= here.w;
    if (isFirst) before = here;
    if (isLast) after = here;
    vec3 way = after.xyz - before.xyz;
    float length2 = dot(way, way);
    vTangent = length2 > 0.0 ? way * inversesqrt(length2) : vec3(1.0, 0.0, 0.0);
    vArc = here.w;

    vec3 arriving = here.xyz - before.xyz;
    vec3 leaving = after.xyz - here.xyz;
    float inLength = max(length(arriving), 1e-6);
    float outLength = max(length(leaving), 1e-6);
    vec3 bend = isFirst || isLast ? vec3(0.0) : 2.0 * (leaving / outLength - arriving / inLength) / (inLength + outLength);

    uvec2 surface = texelFetch(uSurface, index).rg;
    vec3 toViewer = normalize(uViewer.xyz - uViewer.w * here.xyz);
    vec3 normal = unpackDirection(surface.g);
    float facing = clamp(4.0 * dot(normal, toViewer), -1.0, 1.0);
    float height = facing * (float(surface.r >> 22) / 1023.0 * 4.0 - 2.0);
    vValue = float(surface.g >> 22) / 1023.0;
    vSlope = max(0.05, length(cross(vTangent, toViewer)));

    vGlow = 0.0;
    if (uAnyState) {
        uint state = texelFetch(uState, int(texelFetch(uOwner, index).r)).r;
        vGlow = state == 1u ? 1.0 : state == 2u ? 0.5 : 0.0;
    }
    return Node(here.xyz, unpackDirection(surface.r), toViewer, facing * normal, height, bend,
                isFirst || isLast);
}

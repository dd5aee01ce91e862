// Nodes of yarns, as the vertex shaders read them, and what the fragment shaders get of them. Few outputs: a software
// driver pays for each of them at every pixel.

uniform samplerBuffer uNodes;      // x y z, arc length (mm)
uniform usamplerBuffer uSurface;   // direction across and height, fabric normal and value; packed
uniform samplerBuffer uHidden;     // where other yarn hides the sky, see openTo()
uniform usamplerBuffer uOwner;     // bonding point
uniform usamplerBuffer uState;     // by bonding point: 0 plain, 1 selected, 2 hovered
uniform mat4 uView;
uniform mat4 uProjection;
uniform vec4 uCut;                 // what lies where its product with a place is negative is cut away
uniform vec4 uViewer;              // eye (w = 1) or direction to a viewer far away (w = 0)
uniform float uRadius;             // mm
uniform bool uAnyState;
uniform int uStride;               // only every so many nodes are drawn
uniform vec3 uColour;              // of the yarn; linear where it is lit, else as shown, as the two below
uniform vec3 uAccent;              // of selected loops
uniform bool uByValue;             // the colour tells a value
uniform vec3 uRamp[7];             // from low to high

out vec3 vTangent;
out float vArc;                    // mm
out float vOpen;                   // 0 .. 1: how much light gets there
out float vSlope;                  // sine of the angle between yarn and line of sight
out vec3 vColour;

const float kMeanHeight = 0.393;   // of the side of a round yarn that is seen over its middle, in diameters

struct Node {
    vec3 place;
    vec3 reference;                // a direction across the yarn that turns with it
    vec3 toViewer;
    float facing;                  // 1: the viewer sees the fabric's front, -1: its back
    vec3 normal;                   // of the fabric, on the viewer's side
    float height;                  // diameters over the fabric's middle, towards the viewer
    vec3 bend;                     // curvature, 1/mm, towards the inside of the bend
    vec4 hidden;                   // to where other yarn hides the sky, and how much of it in all
    float glow;                    // 1 selected, 0.5 hovered, 0
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

// How much light gets to the surface that faces along `outwards`: less low in the fabric, and beside other yarn; what is
// selected is seen there too.
float openTo(Node node, vec3 outwards, float depth) {
    float hidden = max(0.0, 0.25 * node.hidden.w + 0.5 * dot(node.hidden.xyz, outwards));
    float open = (0.2 + 0.8 * smoothstep(-1.5, 0.9, depth)) / (1.0 + 1.4 * hidden);
    return mix(max(0.3, open), 1.0, 0.6 * node.glow);
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
    vSlope = max(0.05, length(cross(vTangent, toViewer)));

    vColour = uColour;
    if (uByValue) {
        float place = float(surface.g >> 22) / 1023.0 * 6.0;
        int i = min(int(place), 5);
        vColour = mix(uRamp[i], uRamp[i + 1], place - float(i));
    }
    float glow = 0.0;
    if (uAnyState) {
        uint state = texelFetch(uState, int(texelFetch(uOwner, index).r)).r;
        glow = state == 1u ? 1.0 : state == 2u ? 0.5 : 0.0;
    }
    vColour = mix(vColour, uAccent, 0.85 * glow);
    vec4 hidden = texelFetch(uHidden, index);
    hidden = vec4((hidden.xyz * 2.0 - 254.0 / 255.0) * 4.0, hidden.w * 8.0);
    return Node(here.xyz, unpackDirection(surface.r), toViewer, facing, facing * normal, height, bend, hidden,
                glow, isFirst || isLast);
}

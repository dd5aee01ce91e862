// Nodes of yarns, as the vertex shaders read them.

uniform samplerBuffer uNodes;      // x y z, arc length (mm)
uniform usamplerBuffer uSurface;   // reference direction and height, fabric normal; packed
uniform usamplerBuffer uOwner;     // bonding point
uniform usamplerBuffer uState;     // by bonding point: 0 plain, 1 selected, 2 hovered
uniform mat4 uView;
uniform mat4 uProjection;
uniform vec4 uViewer;              // eye (w = 1) or direction to a viewer far away (w = 0)
uniform float uRadius;             // mm
uniform bool uAnyState;

out vec3 vTangent;
out vec3 vNormal;                  // of the fabric, on the viewer's side
out vec3 vToViewer;
out float vArc;                    // mm
out float vHeight;                 // diameters over the fabric, towards the viewer
out vec2 vState;                   // selected, hovered

vec3 unpackDirection(uint bits) {
    vec2 p = vec2(float(bits & 2047u), float((bits >> 11) & 2047u)) / 1023.0 - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) {
        n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    }
    return normalize(n);
}

// Fills the outputs above; returns the node's place, a direction across the yarn and whether the yarn ends here.
vec3 readNode(int node, out vec3 reference, out bool isEnd) {
    vec4 here = texelFetch(uNodes, node);
    vec4 before = texelFetch(uNodes, max(node - 1, 0));
    vec4 after = texelFetch(uNodes, min(node + 1, textureSize(uNodes) - 1));
    // Arc length falls where another yarn begins.
    if (before.w > here.w) before = here;
    if (after.w < here.w) after = here;
    isEnd = before.w == here.w || after.w == here.w;
    vec3 way = after.xyz - before.xyz;
    float length2 = dot(way, way);
    vTangent = length2 > 0.0 ? way * inversesqrt(length2) : vec3(1.0, 0.0, 0.0);
    vToViewer = normalize(uViewer.xyz - uViewer.w * here.xyz);

    uvec2 surface = texelFetch(uSurface, node).rg;
    reference = unpackDirection(surface.r);
    vNormal = unpackDirection(surface.g);
    float facing = clamp(4.0 * dot(vNormal, vToViewer), -1.0, 1.0);
    vHeight = facing * (float(surface.r >> 22) / 1023.0 * 4.0 - 2.0);
    vNormal *= facing;

    vArc = here.w;
    vState = vec2(0.0);
    if (uAnyState) {
        uint state = texelFetch(uState, int(texelFetch(uOwner, node).r)).r;
        vState = vec2(state == 1u ? 1.0 : 0.0, state == 2u ? 1.0 : 0.0);
    }
    return here.xyz;
}

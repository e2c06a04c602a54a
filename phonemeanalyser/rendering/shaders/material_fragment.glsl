// A surface after the metallic-roughness model of glTF 2.0 (appendix B), or in the two steps of MToon of VRM.
uniform sampler2D base_map;
uniform sampler2D surface_map; // green: roughness, blue: metal
uniform sampler2D normal_map;
uniform sampler2D glow_map;
uniform sampler2D shade_map;
uniform float alpha;
uniform vec2 opaque; // what is less opaque than the first, or as much as the second, is not drawn
uniform vec2 metal_and_roughness;
uniform float normal_scale;
uniform vec3 glow; // linear
uniform vec3 shade; // linear
uniform vec2 toon; // shift and sharpness of the end of the shade
uniform float exposure;

in vec2 place;

const float LIT = 0.9; // how bright white is where MToon has it in the light

vec3 facing() {
    vec3 n = normalize(gl_FrontFacing ? normal : -normal);
#ifdef NORMAL_MAP // without tangents in the mesh: C. Schueler, "Followup: Normal Mapping Without Precomputed Tangents"
    vec3 px = cross(dFdy(point), n), py = cross(n, dFdx(point));
    vec3 along = px * dFdx(place).x + py * dFdy(place).x, down = px * dFdx(place).y + py * dFdy(place).y;
    vec3 bent = texture(normal_map, place).xyz * 2.0 - 1.0;
    bent.xy *= normal_scale * inversesqrt(max(max(dot(along, along), dot(down, down)), 1e-20));
    n = normalize(along * bent.x - down * bent.y + n * max(bent.z, 0.05));
#endif
    return n;
}

void main() {
    vec4 base = vec4(colour, alpha), texel;
#ifdef BASE_MAP
    texel = texture(base_map, place);
    base *= vec4(texel.rgb * texel.rgb, texel.a);
#endif
#ifdef CUT
    if (base.a < opaque.x || base.a >= opaque.y) {
        discard;
    }
#endif
    vec3 n = facing();
    vec3 view = normalize(eye - point);
    float open = wet_and_open.y, cosine = dot(n, key), sun = lit(dot(normal, key));
    float nv = clamp(dot(n, view), 1e-3, 1.0);
    float edge = (1.0 - nv) * (1.0 - nv); // is darker, so that white is seen on a white ground
#ifdef TOON
    vec3 shaded = shade;
#ifdef SHADE_MAP
    texel = vec4(texture(shade_map, place).rgb, 1.0);
    shaded *= texel.rgb * texel.rgb;
#endif
    float step_of = clamp((cosine + toon.x + 1.0 - toon.y) / max(2.0 - 2.0 * toon.y, 1e-3), 0.0, 1.0);
    vec3 shown = mix(shaded, base.rgb, step_of * sun) * (LIT * strength * (0.82 + 0.18 * open) * (1.0 - 0.45 * edge));
#else
    float metal = metal_and_roughness.x, rough = metal_and_roughness.y;
#ifdef SURFACE_MAP
    vec2 said = texture(surface_map, place).bg;
    metal *= said.x;
    rough *= said.y;
#endif
    float a = max(rough * rough, 0.02), a2 = a * a;
    vec3 mirrored = mix(vec3(0.04), base.rgb, metal), spread = base.rgb * (1.0 - metal);
    vec3 between = normalize(key + view);
    float nl = max(cosine, 0.0), nh = max(dot(n, between), 0.0), ends = 1.0 - max(dot(view, between), 0.0);
    float round_of = nh * nh * (a2 - 1.0) + 1.0;
    float lobe = 0.5 * a2 / (round_of * round_of * max(mix(2.0 * nl * nv, nl + nv, a), 1e-3));
    vec3 fresnel = mirrored + (1.0 - mirrored) * (ends * ends * ends * ends * ends);
    vec3 shown = KEY * (nl * sun) * (spread + fresnel * lobe);
    float held = open * (0.65 + 0.35 * open);
    vec3 around = FILL * max(0.8 * dot(n, fill) + 0.2, 0.0);
    shown += (around + mix(FLOOR, CEILING, 0.5 + 0.5 * n.y)) * held * spread;
    // what a room reflects: B. Karis, "Physically Based Shading on Mobile" (2014)
    vec4 r = rough * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float curve = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
    vec2 share = vec2(-1.04, 1.04) * curve + r.zw;
    vec3 mirror = reflect(-view, n);
    vec3 room = mix(FLOOR, 2.0 * CEILING, smoothstep(-0.6 - rough, 0.6 + rough, mirror.y)) + around;
    shown += room * held * (mirrored * share.x + share.y);
    shown += RIM * ((max(dot(n, rims[0]), 0.0) + max(dot(n, rims[1]), 0.0)) * edge * edge * open) * base.rgb;
    shown *= strength * exposure * (1.0 - 0.3 * edge);
#endif
#ifdef GLOW_MAP
    texel = texture(glow_map, place);
    shown += glow * texel.rgb * texel.rgb;
#else
    shown += glow;
#endif
    painted = vec4(shown_of(without_reflection(shown)), opaque.y > 1.0 ? 1.0 : base.a);
}

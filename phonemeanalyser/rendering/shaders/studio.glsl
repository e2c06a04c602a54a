// A studio: a warm key light with a shadow, a cool fill light, two rim lights from behind, a bright ceiling.
// Colours are squared where light adds up, and rooted at the end: close to sRGB, and cheap without a graphics card.
uniform sampler2DShadow shadow;
uniform vec3 eye;
uniform vec3 key;
uniform vec3 fill;
uniform vec3 rims[2];
uniform float strength;

in vec3 point;
in vec3 normal;
in vec3 colour;
in vec2 wet_and_open;
in vec3 in_key;
in vec2 lean;

out vec4 painted;

const vec3 KEY = vec3(1.62, 1.48, 1.33);
const vec3 FILL = vec3(0.24, 0.28, 0.35);
const vec3 RIM = vec3(0.75, 0.85, 1.0);
const vec3 CEILING = vec3(0.46, 0.48, 0.53);
const vec3 FLOOR = vec3(0.22, 0.165, 0.14);

float lit(float cosine) { // a shadow grows soft over the places where it is looked up
    float sum = 0.0;
    for (int k = 0; k < TAPS.length(); k++) {
        sum += texture(shadow, in_key + vec3(TAPS[k], dot(lean, TAPS[k]) - 0.003));
    }
    return mix(1.0, sum / float(TAPS.length()), smoothstep(-0.05, 0.25, cosine)); // light that grazes skin has no sharp end
}

// The tone curve PBR Neutral by the Khronos Group: base colours stay as they are, and bright ones keep their drawing.
// See section "PBR Neutral Specification" of https://github.com/KhronosGroup/ToneMapping
const float REFLECTED = 0.04;
const float COMPRESSED = 0.8 - REFLECTED; // from here on
const float DESATURATION = 0.15;

vec3 shown_of(vec3 light) {
    float peak = max(max(light.r, max(light.g, light.b)), 1e-6);
    float room = 1.0 - COMPRESSED;
    float most = peak < COMPRESSED ? peak : 1.0 - room * room / (peak + room - COMPRESSED);
    float kept = 1.0 / (DESATURATION * (peak - most) + 1.0);
    return sqrt(mix(vec3(most), light * (most / peak), kept));
}

vec3 without_reflection(vec3 light) { // what every surface reflects of its surroundings makes colours pale
    float least = min(light.r, min(light.g, light.b));
    return light - (least < 2.0 * REFLECTED ? least - least * least / (4.0 * REFLECTED) : REFLECTED);
}

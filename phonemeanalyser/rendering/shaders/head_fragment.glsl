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
const vec3 BLEEDING = vec3(0.42, 0.20, 0.13); // how far light goes round in skin: red farthest

float lit(float cosine) { // a shadow grows soft over the places where it is looked up
    float sum = 0.0;
    for (int k = 0; k < TAPS.length(); k++) {
        sum += texture(shadow, in_key + vec3(TAPS[k], dot(lean, TAPS[k]) - 0.003));
    }
    return mix(1.0, sum / float(TAPS.length()), smoothstep(-0.05, 0.25, cosine)); // light that grazes skin has no sharp end
}

vec3 wrapped(float cosine, vec3 bleeding) {
    vec3 light = clamp((cosine + bleeding) / (1.0 + bleeding), 0.0, 1.0);
    return light * light;
}

float glint(float cosine) { // of the angle between a light and its mirror image
    float x = max(cosine, 0.0);
    x *= x;
    return x * x;
}

float sharp(float x) {
    x *= x;
    x *= x;
    return x * x * x * x;
}

void main() {
    vec3 n = normalize(normal);
    vec3 view = normalize(eye - point);
    float wetness = wet_and_open.x;
    float open = wet_and_open.y;
    float away = 1.0 - max(dot(n, view), 0.0);
    float edge = away * away * away * away;
    float cosine = dot(n, key);
    vec3 mirror = reflect(-view, n);
    float inside = smoothstep(0.02, 0.3, open); // what a closed mouth hides is never quite bright
    float sun = mix(lit(cosine), 0.85, 0.9 * wetness * (1.0 - inside)); // light is thrown about between teeth
    sun *= mix(0.25 + 0.75 * wetness, 1.0, inside);

    vec3 bleeding = BLEEDING * (1.0 - 0.6 * wetness);
    vec3 soft = mix(vec3(0.10, 0.02, 0.01), vec3(1.0), sun); // a shadow on skin has a red edge
    vec3 light = KEY * wrapped(cosine, bleeding) * soft;
    open = max(open, wetness);
    float held = open * (0.65 + 0.35 * open);
    vec3 around = mix(vec3(held, held * held, held * held), vec3(held), 0.55); // creases are warm
    light += (FILL * max(0.8 * dot(n, fill) + 0.2, 0.0) + mix(FLOOR, CEILING, 0.5 + 0.5 * n.y)) * around;
    vec3 shown = colour * light;

    float rim = max(dot(n, rims[0]), 0.0) + max(dot(n, rims[1]), 0.0);
    shown += RIM * (rim * edge * open) * (0.25 + 0.75 * colour);

    float gleam = glint(dot(mirror, key));
    shown += KEY * (sun * gleam * (0.035 + 0.2 * edge) * (1.0 - wetness));
    float ball = max(wetness - 0.8, 0.0) * 5.0; // an eye: small lights, and the window's picture in it
    float window = smoothstep(0.28, 0.5, gleam * gleam * gleam * gleam) * ball;
    float wet = (0.2 + 0.8 * sun) * (sharp(gleam) + window) + 0.12 * gleam * sun * (1.0 - ball);
    wet += 0.2 * sharp(glint(dot(mirror, fill)));
    shown += KEY * (wet * wetness * smoothstep(0.0, 0.3, open + 0.1));

    shown *= strength;
    shown = shown * (1.0 + shown * 0.1) / (1.0 + 0.3 * shown); // bright places keep their drawing
    painted = vec4(sqrt(shown), 1.0);
}

// Skin of one colour at each vertex, as the heads of the program have it: light goes round in it, and lips are wet.
uniform float exposure;

const vec3 BLEEDING = vec3(0.42, 0.20, 0.13); // how far light goes round in skin: red farthest

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

    painted = vec4(shown_of(shown * strength * exposure), 1.0);
}

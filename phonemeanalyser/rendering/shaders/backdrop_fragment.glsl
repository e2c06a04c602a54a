// A soft glow behind the head, which ends before the picture does: pictures side by side have no seam.
uniform vec3 background;
uniform vec3 glow;

in vec2 place;

out vec4 painted;

void main() {
    float near = 1.0 - smoothstep(0.0, 1.0, length(place - vec2(0.0, 0.05)));
    painted = vec4(mix(background, glow, near), 1.0);
}

uniform vec3 paint;

in vec3 colour;

out vec4 painted;

void main() {
    painted = vec4(mix(sqrt(colour), paint, 0.6), 1.0);
}

uniform vec3 paint;

out vec4 painted;

void main() {
    painted = vec4(paint, 1.0);
}

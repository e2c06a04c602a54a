// What is seen from its back; but for slivers along the outline, whose side is lost when corners are rounded to pixels.
uniform vec3 paint;

in float facing;

out vec4 painted;

void main() {
    if (facing > -0.15) {
        discard;
    }
    painted = vec4(paint, 1.0);
}

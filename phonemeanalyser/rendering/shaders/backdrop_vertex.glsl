in vec2 in_corner;

out vec2 place; // -1..1 from edge to edge

void main() {
    place = in_corner;
    gl_Position = vec4(in_corner, 1.0, 1.0);
}

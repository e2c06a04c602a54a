uniform mat4 camera;

in vec3 in_position;
in vec2 in_place;

out vec2 place;

void main() {
    place = in_place;
    gl_Position = camera * vec4(turned(in_position), 1.0);
}

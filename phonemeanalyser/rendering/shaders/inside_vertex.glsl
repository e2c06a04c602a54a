uniform mat4 camera;
uniform vec3 eye;

in vec3 in_position;
in vec3 in_normal;

out float facing; // cosine of the angle between the surface and the viewer

void main() {
    vec3 point = turned(in_position);
    facing = dot(normalize(turned_normal(in_position, in_normal)), normalize(eye - point));
    gl_Position = camera * vec4(point, 1.0);
}

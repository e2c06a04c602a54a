uniform mat4 camera;
uniform mat4 key_view;
uniform float lift; // how far above the skin its shadow is looked up

in vec3 in_position;
in vec3 in_normal;
in vec3 in_colour; // linear
in float in_wetness;
in float in_openness;
in vec2 in_place;

out vec3 point;
out vec3 normal;
out vec3 colour;
out vec2 wet_and_open;
out vec2 place; // in the textures
out vec3 in_key;
out vec2 lean; // how much deeper skin lies for the key light, beside this place

void main() {
    point = turned(in_position);
    normal = turned_normal(in_position, in_normal);
    colour = in_colour;
    place = in_place;
    wet_and_open = vec2(in_wetness, in_openness);
    in_key = (key_view * vec4(point + lift * normal, 1.0)).xyz * 0.5 + 0.5;
    vec3 seen = mat3(key_view) * normal;
    lean = clamp(-seen.xy / min(seen.z, -1e-6), -2.5, 2.5);
    gl_Position = camera * vec4(point, 1.0);
}

// What casts a shadow where its texture is opaque.
uniform sampler2D base_map;
uniform float alpha;
uniform vec2 opaque;

in vec2 place;

void main() {
    if (alpha * texture(base_map, place).a < opaque.x) {
        discard;
    }
}

// The head turns on its neck: what is below turns less, and the lowest not at all.
uniform mat3 turn;
uniform vec3 pivot;
uniform vec2 stem; // where the neck ends below, and where it is part of the head

vec3 turned(vec3 point) {
    return mix(point, turn * (point - pivot) + pivot, smoothstep(stem.x, stem.y, point.y));
}

vec3 turned_normal(vec3 point, vec3 normal) {
    return mix(normal, turn * normal, smoothstep(stem.x, stem.y, point.y));
}

// Smooths the jagged edges of a picture that has one sample a pixel: where it changes much, along the edge.
uniform sampler2D picture;

out vec4 painted;

const float LEAST = 0.06; // change of green, which the eye sees most of, from which on there is an edge
const float FARTHEST = 6.0; // pixels along an edge that is nearly level or upright

float green(ivec2 at) {
    return texelFetch(picture, at, 0).g;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 most = textureSize(picture, 0) - 1;
    float up = green(ivec2(at.x, min(at.y + 1, most.y))) - green(ivec2(at.x, max(at.y - 1, 0)));
    float right = green(ivec2(min(at.x + 1, most.x), at.y)) - green(ivec2(max(at.x - 1, 0), at.y));
    vec2 along = vec2(up, -right);
    along = clamp(along / max(min(abs(up), abs(right)), 0.05), -FARTHEST, FARTHEST) * step(LEAST, abs(up) + abs(right));
    vec2 pixel = 1.0 / vec2(most + 1);
    vec2 ahead = (gl_FragCoord.xy + along / 5.0) * pixel, behind = (gl_FragCoord.xy - along / 5.0) * pixel;
    painted = 0.5 * (texture(picture, ahead) + texture(picture, behind));
}

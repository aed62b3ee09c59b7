// Prelude of every line shader's fragments: the layer's finished depth.

uniform sampler2D finished_depth;  // window depth over the viewport
uniform float away;                // +1 where greater depth is farther away, else -1

float depth_at(ivec2 pixel) {
    ivec2 last = textureSize(finished_depth, 0) - 1;
    return texelFetch(finished_depth, clamp(pixel, ivec2(0), last), 0).r;
}

// Whether a place (pixels in the viewport, window depth) lies behind what is drawn there, by more
// than slack. Depth is taken between pixel centres, so that it is a surface's own at the place.
bool hidden(vec3 place, float slack) {
    vec2 from = floor(place.xy - 0.5), share = place.xy - 0.5 - from;
    ivec2 p = ivec2(from);
    vec2 low = vec2(depth_at(p), depth_at(p + ivec2(1, 0)));
    vec2 high = vec2(depth_at(p + ivec2(0, 1)), depth_at(p + ivec2(1, 1)));
    vec2 row = mix(low, high, share.y);
    return away * (place.z - mix(row.x, row.y, share.x)) > slack;
}

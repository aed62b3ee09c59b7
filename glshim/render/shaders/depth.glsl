// Prelude of every line shader's fragments: the layer's finished depth.

uniform sampler2D finished_depth;  // window depth over the viewport
uniform float away;                // +1 where greater depth is farther away, else -1
uniform float blur;                // pixels by which depths may not be those of pixel centres

// Whether a plane lies behind what is drawn beside a place on a side (pixels in the viewport,
// window depth), by more than slack: at the centre of the nearest pixel outwards (a unit vector)
// of the side. slope: the plane's depth a pixel.
bool hidden(vec3 place, vec2 slope, vec2 outwards, float slack) {
    float least = 0.04 + blur;
    ivec2 corner = ivec2(floor(place.xy + (least + 0.01) * outwards - 0.5)), pixel = corner;
    float nearest = 9.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 p = corner + ivec2(i & 1, i >> 1);
        float beyond = dot(vec2(p) + 0.5 - place.xy, outwards);
        if (beyond > least && beyond < nearest) { nearest = beyond; pixel = p; }
    }
    slack += blur * length(slope);
    float depth = place.z + dot(slope, vec2(pixel) + 0.5 - place.xy);
    pixel = clamp(pixel, ivec2(0), textureSize(finished_depth, 0) - 1);
    return away * (depth - texelFetch(finished_depth, pixel, 0).r) > slack;
}

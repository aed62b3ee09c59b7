// What:   what tones share: the app's picture, where its surfaces are, and the paper.
// Inputs: the app's finished picture and depth (depth.glsl); the paper's grain (tones.py).
// Source: McGuire & Hughes 2004, figure 7. The grain is fixed to the screen, as paper is:
//         tones ask for it by places on_paper, for the picture by pixels.

uniform sampler2D app_colour;
uniform sampler2D stroke;  // the paper: tooth, cloud, other cloud
uniform vec3 paper;
uniform int behind;        // 1: paper is seen where no surface is
uniform int backed;        // 1: the app has drawn on a background of the paper's colour
uniform vec3 ink;

const float ALIKE = 4.5 / 255.0;  // of a channel: what rounding makes of one colour

vec3 shown(vec2 place) {
    return texelFetch(app_colour, ivec2(clamp(place, port.xy, port.zw)), 0).rgb;
}

// Whether something with depth was drawn there: nearer than the far plane.
bool solid(vec2 place) {
    return finished(place) < max(away, 0.0);
}

// Whether something was drawn there, be it scenery without depth.
bool surface(vec2 place) {
    if (solid(place)) return true;
    vec3 off = abs(shown(place) - paper);
    return behind * backed == 1 && max(max(off.r, off.g), off.b) > ALIKE;
}

float brightness(vec3 c) {
    return dot(c, vec3(0.299, 0.587, 0.114));
}

// Where a place lies on the paper, in pixels of the window: paper is as large in a larger picture.
vec2 on_paper(vec2 place) {
    return (place + shot.xy) / shot.z;
}

vec3 speck(ivec2 at) {
    return texelFetch(stroke, at & 511, 0).rgb;
}

// The paper at a place on it: 0..1, all equally common.
vec3 grain(vec2 spot) {
    if (shot.z == 1.0) return speck(ivec2(floor(spot)));
    ivec2 at = ivec2(floor(spot - 0.5));
    vec2 share = fract(spot - 0.5);
    return mix(mix(speck(at), speck(at + ivec2(1, 0)), share.x),
               mix(speck(at + ivec2(0, 1)), speck(at + ivec2(1, 1)), share.x), share.y);
}

// The same, drawn out by a factor.
vec3 grain(vec2 spot, float factor) {
    return textureLod(stroke, fract(spot / (512.0 * factor)), 0.0).rgb;
}

// Bare paper, with light from the side on its tooth.
vec3 bare(vec2 spot) {
    float slope = grain(spot).r - grain(spot + vec2(1.0, -1.0)).r;
    return paper * (1.0 + 0.035 * slope - 0.025 * grain(spot, 3.0).g);
}

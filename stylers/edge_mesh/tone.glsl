// What:   what tones share: the app's picture, where its surfaces are, and the paper.
// Inputs: the app's finished picture and depth (depth.glsl); the paper's grain (tones.py).
// Source: McGuire & Hughes 2004, figure 7. The grain is fixed to the screen, as paper is.

uniform sampler2D app_colour;
uniform sampler2D stroke;  // the paper: tooth, cloud, other cloud
uniform vec3 paper;
uniform int behind;        // 1: paper is seen where no surface is
uniform vec3 ink;

// Whether something was drawn there: nearer than the far plane.
bool surface(vec2 place) {
    return finished(place) < max(away, 0.0);
}

vec3 shown(vec2 place) {
    return texelFetch(app_colour, ivec2(clamp(place, port.xy, port.zw)), 0).rgb;
}

float brightness(vec3 c) {
    return dot(c, vec3(0.299, 0.587, 0.114));
}

// The paper at a pixel: 0..1, all equally common.
vec3 grain(vec2 place) {
    return texelFetch(stroke, ivec2(place) & 511, 0).rgb;
}

// The same, drawn out by a factor.
vec3 grain(vec2 place, float factor) {
    return textureLod(stroke, fract(place / (512.0 * factor)), 0.0).rgb;
}

// Bare paper, with light from the side on its tooth.
vec3 bare(vec2 place) {
    float slope = grain(place).r - grain(place + vec2(1.0, -1.0)).r;
    return paper * (1.0 + 0.035 * slope - 0.025 * grain(place, 3.0).g);
}

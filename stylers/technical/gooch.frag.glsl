// What:   tones from cool to warm by the way that a surface faces the light.
// Inputs: pixel.glsl, lamps.glsl (stylers/shared/shading), of which there is one.
// Source: A. Gooch, B. Gooch, P. Shirley, E. Cohen, "A Non-Photorealistic Lighting Model for
//         Automatic Technical Illustration", SIGGRAPH 1998, equations 1 to 4. Numpy reference, also
//         of tones that keep hues: glshim/model/lights.py.

uniform vec4 paint;        // alpha 0: the app's
uniform vec3 tint;         // of the app's light, for its paint
uniform float blue, yellow, alpha, beta;
uniform float hue;         // share of the surface's own hue that is kept; 0: the paper's tones
uniform float highlight;   // brightness of highlights
uniform float gloss;

const vec3 WARM = vec3(1.0, 0.9, 0.6), COOL = vec3(0.35, 0.45, 0.85);  // what greys turn to
const float COOL_LIGHT = 0.455;  // luminance of COOL
const float DARK = 0.2;          // colours darker than that count as greyer than they are

void main() {
    Pixel p = this_pixel();
    Falling f = falling(lamps - 1, p);  // drivers shorten arrays that constants alone index
    vec3 base = paint.a > 0.0 ? paint.rgb : p.shown * tint;
    float most = max(max(base.r, base.g), base.b), least = min(min(base.r, base.g), base.b);
    float strong = (most - least) / max(most, DARK);
    vec3 own = base / max(most, 1e-3);
    vec3 toward_cool = mix(vec3(0.0, 0.0, 1.0), mix(COOL, COOL_LIGHT * own, strong), hue);
    vec3 toward_warm = mix(vec3(1.0, 1.0, 0.0), mix(WARM, own, strong), hue);
    vec3 cool = min(blue * toward_cool + alpha * base, 1.0);
    vec3 warm = min(yellow * toward_warm + beta * base, 1.0);
    vec3 found = mix(cool, warm, 0.5 + 0.5 * dot(p.lit, f.way));
    float gleam = pow(max(dot(reflect(-f.way, p.lit), p.sight), 0.0), gloss);
    bool bent = is_bent(p);
    if (!p.own) discard;
    if (bent && p.gleams) found += highlight * gleam;
    colour = vec4(in_fog(min(found, 1.0), p.clear), 1.0);
}

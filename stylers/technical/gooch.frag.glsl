// What:   tones from cool to warm by the way that a surface faces the light.
// Inputs: pixel.glsl, lamps.glsl (stylers/shared/shading), of which there is one.
// Source: A. Gooch, B. Gooch, P. Shirley, E. Cohen, "A Non-Photorealistic Lighting Model for
//         Automatic Technical Illustration", SIGGRAPH 1998, equations 1 to 4. Numpy reference:
//         glshim/model/lights.py.

uniform vec4 paint;        // alpha 0: the app's
uniform float blue, yellow, alpha, beta;
uniform float highlight;   // brightness of highlights
uniform float gloss;

void main() {
    Pixel p = this_pixel();
    Falling f = falling(lamps - 1, p);  // drivers shorten arrays that constants alone index
    vec3 base = paint.a > 0.0 ? paint.rgb : p.shown;
    vec3 cool = min(vec3(0.0, 0.0, blue) + alpha * base, 1.0);
    vec3 warm = min(vec3(yellow, yellow, 0.0) + beta * base, 1.0);
    vec3 found = mix(cool, warm, 0.5 + 0.5 * dot(p.n, f.way));
    float gleam = pow(max(dot(reflect(-f.way, p.n), p.sight), 0.0), gloss);
    bool bent = is_bent(p);
    if (!p.own) discard;
    if (bent && p.gleams) found += highlight * gleam;
    colour = vec4(min(found, 1.0), 1.0);
}

// What:   surfaces lit pixel by pixel, smooth or in flat bands as on a cel.
// Inputs: pixel.glsl (stylers/shared/shading), the light.
// Source: Rideout 2010 (per-pixel lighting from the G-buffer, the dragon's cel shader); J. Blinn,
//         "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977.

uniform vec4 lamp;   // eye space, homogeneous; zero: the viewer's own
uniform vec4 paint;  // alpha 0: the app's
uniform float shine;
uniform float bands; // 0: none
uniform float ambient;

const float HEADLIGHT = 0.3;  // of what the light leaves dark
const float GLOSS = 40.0;
const float PALED = 0.6;      // power of the app's brightness: less of its own shading is left
const float PAINTS = 1.0;     // on a cel, in a ratio of 2
const float AIRBRUSHED = 0.25; // of what these leave out: tiles of like paints stay apart

// The app's colour without most of its shading; on a cel one of a few paints.
vec3 painted(vec3 shown) {
    float value = max(max(shown.r, shown.g), shown.b), level = log2(max(value, 0.01));
    if (bands > 0.0) level = mix(floor(PAINTS * level + 0.5) / PAINTS, level, AIRBRUSHED);
    return shown / max(value, 1e-3) * min(exp2(PALED * level), 1.0);
}

void main() {
    Pixel p = this_pixel();
    vec3 to_light = lamp.xyz - lamp.w * p.spot;
    to_light = dot(to_light, to_light) > 0.0 ? normalize(to_light) : p.sight;
    float lit = max(dot(p.n, to_light), 0.0), seen = max(dot(p.n, p.sight), 0.0);
    float bright = max(lit, HEADLIGHT * seen);
    vec3 middle = normalize(to_light + p.sight);
    float gleam = lit > 0.0 ? pow(max(dot(p.n, middle), 0.0), GLOSS) : 0.0;
    // A flat face under parallel light, seen in parallel, would shine as a whole.
    if (length(fwidth(p.n)) + length(fwidth(middle)) < 1e-5) gleam = 0.0;

    vec3 base = paint.a > 0.0 ? paint.rgb : painted(p.shown);
    if (bands > 0.0) {
        float blur = p.crisp ? 0.0 : min(bands * fwidth(bright), 0.5);
        bright = min(stepped(bands * bright, blur), bands - 1.0) / (bands - 1.0);
        gleam = smoothstep(-0.5, 0.5, (gleam - 0.5) / max(fwidth(gleam), 1e-4));
    }
    if (!p.own) discard;
    float shade = ambient + (1.0 - ambient) * bright;
    colour = vec4(in_fog(min(base * shade + shine * gleam, 1.0), p.clear), 1.0);
}

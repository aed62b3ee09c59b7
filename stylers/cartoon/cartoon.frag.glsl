// What:   flat bands of light over the app's paints, as on a cel: highlights and rims too.
// Inputs: pixel.glsl, lamps.glsl (stylers/shared/shading): the app's picture holds its paints,
//         unlit.
// Source: A. Lake et al., "Stylized Rendering Techniques for Scalable Real-Time 3D Animation", NPAR
//         2000, section 3; rims: P. Barla et al., "X-Toon", NPAR 2006, section 3.2 (a tone that
//         depends on n . v). Numpy reference of the bands: glshim/model/lights.py.

uniform float bands;
uniform float exposure;     // of the light
uniform float shadow;       // brightness of the darkest band
uniform vec3 shadow_tint;
uniform float highlight;    // brightness of highlights
uniform float gloss;
uniform float rim;          // brightness of rims
uniform float saturation;   // 1: as the app has it
uniform float paints;       // levels of the app's paint; 0: as it is

const vec3 LUMA = vec3(0.2126, 0.7152, 0.0722);  // ITU-R BT.709
const float LOCAL = 0.5;    // share of the light's colour that is the place's own
const float RIM = 0.35;     // n . v below which a rim is

float brightest(vec3 c) { return max(max(c.r, c.g), c.b); }

// An edge at zero, smooth over a pixel.
float edge(float value) { return smoothstep(-0.7, 0.7, value / max(fwidth(value), 1e-5)); }

vec3 posterised(vec3 c) {
    float value = brightest(c);
    if (paints == 0.0 || value <= 0.0) return c;
    return c * (max(floor(value * paints + 0.5), 0.5) / paints / value);
}

// Light in bands, 0..1, whose edges are smooth over a pixel.
float banded(float light, bool crisp) {
    float level = clamp(exposure * light, 0.0, 1.0);
    float blur = crisp ? 0.0 : min(bands * fwidth(level), 0.5);
    return min(stepped(bands * level, blur), bands - 1.0) / (bands - 1.0);
}

// The colour of the light: bands are of its brightness alone, so that under lamps of several
// colours none has patches of its own; half of it is that of all lamps together. More than white
// is white, as on the screen.
vec3 hue(vec3 light) {
    vec3 all = vec3(0.0);
    for (int k = 0; k < lamps; ++k) all += lamp_shade[k];
    all = min(all, 1.0);
    light = min(light, 1.0);
    vec3 usual = brightest(all) > 0.0 ? all / brightest(all) : vec3(1.0);
    return brightest(light) > 0.0 ? mix(usual, light / brightest(light), LOCAL) : usual;
}

void main() {
    Pixel p = this_pixel();
    vec3 light = incoming(p), lit = hue(light);
    float level = banded(brightest(light), p.crisp);
    float shine = edge(brightest(gleaming(p, gloss)) - 0.5);
    float outer = edge(RIM - dot(p.n, p.sight));
    bool bent = is_bent(p);
    if (!p.own) discard;
    vec3 found = posterised(p.shown) * mix(shadow * shadow_tint, lit, level);
    if (!p.gleams) shine = 0.0;
    if (bent) found += highlight * shine + rim * outer * level * (1.0 - shine);
    found = mix(vec3(dot(found, LUMA)), found, saturation);
    colour = vec4(in_fog(clamp(found, 0.0, 1.0), p.clear), 1.0);
}

// What:   hatching that is held by the surface: planes through the object, as far apart as suits
//         the screen, drawn where the light leaves it dark; crossed where it is darker still.
// Inputs: seen_normal.glsl, fog.glsl; the surface's place and normal (hatch.vert.glsl), the lamps,
//         the app's finished picture.
// Source: NPRQuake's hatch textures by brightness; strokes whose number and width say how dark it
//         is: G. Winkenbach, D. Salesin, "Computer-Generated Pen-and-Ink Illustration", SIGGRAPH
//         1994; levels of strokes that fade in: E. Praun et al., "Real-Time Hatching", SIGGRAPH
//         2001.

uniform mat4 projection;
uniform vec4 viewport;
uniform vec2 range;         // window depths of the near and the far plane, greater is farther
uniform mat4 modelview;
uniform sampler2D app_colour;
uniform sampler2D stroke;   // the paper's grain
uniform vec4 viewpoint;
uniform int lamps;
uniform vec4 lamp_place[8]; // eye space, homogeneous
uniform vec3 lamp_shade[8]; // diffuse
uniform vec3 ink;
uniform float apart;        // pixels between strokes, about
uniform float darkness;     // of the hatching, 0..1
uniform float by_picture;   // share of the darkness that the app's own picture says
uniform float jitter;       // pixels by which strokes stray
uniform float jitter_seed;
uniform float soft;         // strokes of a soft lead, 0..1
uniform float coloured;     // share of the program's own colours in the ink

const float EDGE_ON = 0.4;  // cosine between a triangle's normal and the line of sight

in vec3 spot;
in vec3 upright;
in vec3 held;

vec3 grain(vec2 at) { return textureLod(stroke, fract(at / 512.0), 0.0).rgb; }

// Units of a direction in object space that a smooth surface gains in a pixel, and (y) the most
// that it could gain. n, sight: eye space.
vec2 gained(vec3 across, vec3 n, vec3 sight) {
    vec3 g = across * inverse(mat3(modelview));  // its gradient in eye space
    float steep = dot(g, sight) / max(dot(n, sight), 0.15);
    vec2 flow = vec2(g.x - steep * n.x, g.y - steep * n.y);
    float w = (projection * vec4(spot, 1.0)).w;
    return vec2(length(flow), length(g)) * abs(w / (projection[1][1] * viewport.w));
}

// Ink of strokes that lie in planes across a direction of object space. dark: 0..1 to cover.
float strokes(vec3 across, float dark, float number, vec3 n, vec3 sight) {
    float place = dot(held, across);
    vec2 smoothly = gained(across, n, sight);
    // How far apart strokes are the smooth surface says, how wide they are the facet itself.
    float slope = max(length(vec2(dFdx(place), dFdy(place))), 1e-12);
    float spread = clamp(smoothly.x, 0.6 * slope, 1.6 * slope);
    float level = log2(apart * spread), fine = floor(level), part = level - fine;
    float at = place / exp2(fine);              // a stroke a unit; half of them at the next level
    float pixel = exp2(fine) / slope;           // pixels a unit: apart / 2 .. apart
    vec2 on_sheet = (gl_FragCoord.xy + shot.xy) / shot.z;
    vec3 wander = grain(on_sheet * 0.35 + 97.0 * number + 31.0 * jitter_seed);
    at += jitter * (wander.g - 0.5) / pixel;
    float nearest = floor(at + 0.5), off = abs(at - nearest) * pixel;
    bool odd = mod(nearest, 2.0) > 0.5;
    float press = 0.8 + 0.5 * wander.b;
    float half_width = 0.275 * dark * min(pixel, apart) * press * (odd ? 1.0 - part : 1.0);
    float tooth = 0.75 + 0.5 * grain(on_sheet).r;
    float cover = clamp(half_width + 0.5 - off, 0.0, 1.0) * min(2.0 * half_width, 1.0);
    float lead = exp(-off * off / (1.6 * half_width * half_width + 0.4)) * min(half_width, 1.0);
    lead *= smoothstep(-0.35, 0.55, press - 0.75 * grain(on_sheet + 71.0).r);
    cover = mix(cover, 0.62 * lead, soft);
    // A face across the direction has no strokes of it, one nearly so would have them anywhere.
    return clamp(cover * tooth, 0.0, 1.0) * smoothstep(0.1, 0.3, slope / max(smoothly.y, 1e-12));
}

// How a surface faces the lamps, 0..1: the brighter ones count for more.
float lit(vec3 n) {
    float found = 0.0, all = 1e-6;
    for (int k = 0; k < lamps; ++k) {
        float share = max(max(lamp_shade[k].r, lamp_shade[k].g), lamp_shade[k].b);
        vec3 way = normalize(lamp_place[k].xyz - lamp_place[k].w * spot);
        found += share * (0.5 + 0.5 * dot(n, way));
        all += share;
    }
    return found / all;
}

// Whether depth goes on from here as the triangle does, to one side at least.
bool goes_on(vec2 way, float here, float rise) {
    float most = 0.6 * abs(rise) + hair;
    return abs(finished(gl_FragCoord.xy + way) - here - rise) <= most
        || abs(finished(gl_FragCoord.xy - way) - here + rise) <= most;
}

// Whether the triangle is what is seen here. Of one that is seen nearly edge on the rim may be as
// near as what hides the rest: the inner faces of boxes side by side.
bool is_seen(vec3 sight) {
    vec3 area = cross(dFdx(spot), dFdy(spot));
    vec2 place = (projection * vec4(spot, 1.0)).zw;
    float here = mix(range.x, range.y, 0.5 + 0.5 * place.x / place.y);
    vec2 rise = vec2(dFdx(here), dFdy(here));
    if (abs(dot(area, sight)) > EDGE_ON * length(area)) return true;
    return goes_on(vec2(1.0, 0.0), here, rise.x) && goes_on(vec2(0.0, 1.0), here, rise.y);
}

void main() {
    vec3 sight = normalize(viewpoint.xyz - viewpoint.w * spot);
    vec3 n = seen_normal(spot, upright, sight);
    bool hidden = !is_seen(sight);
    float light = lit(n);
    vec3 shown = texelFetch(app_colour, ivec2(gl_FragCoord.xy), 0).rgb;
    float picture = dot(shown, vec3(0.299, 0.587, 0.114));
    float bright = mix(light * light, picture, by_picture);
    float dark = 1.2 * darkness * (1.0 - bright) * clear_share(spot);

    // The families are askew to all axes, so that no face of a box lies along one.
    vec3 first = normalize(vec3(0.62, 0.71, 0.34)), second = normalize(vec3(-0.75, 0.58, 0.31));
    vec3 third = normalize(vec3(0.2, 0.45, -0.87));
    float cover = strokes(first, smoothstep(0.08, 0.8, dark), 0.0, n, sight);
    cover = max(cover, strokes(second, smoothstep(0.5, 0.95, dark), 1.0, n, sight));
    cover = max(cover, strokes(third, smoothstep(0.75, 1.1, dark), 2.0, n, sight));
    if (hidden || cover <= 0.004) discard;
    float value = max(max(shown.r, shown.g), max(shown.b, 0.05));
    vec3 crayon = shown / value * (0.25 + 0.4 * value);
    colour = vec4(mix(ink, crayon, coloured), 1.0) * cover;
}

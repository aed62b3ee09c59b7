// What:   the program's own text and lines over the picture, in colours that can be read there: the
//         hue stays, darker or lighter until the contrast with what lies around is enough.
//         GLSL 1.20 and, with faster look-ups, 1.30.
// Inputs: ink: what was gathered, colour by coverage; ink_depth: its depth; finished_depth, ground:
//         the picture below it. Each with the size of its texture. box: least and greatest centre.
// Source: contrast: Web Content Accessibility Guidelines 2.2, success criterion 1.4.3.
uniform sampler2D ink;
uniform sampler2D ink_depth;
uniform sampler2D ground;
uniform sampler2D finished_depth;
uniform vec2 ink_size;
uniform vec2 ground_size;
uniform vec2 depth_size;
uniform vec3 home;       // the program's own background
uniform vec4 box;
uniform float hair;      // a few steps of the depth buffer
uniform float scale;     // pixels for one of the window
uniform int tested;      // 1: surfaces that are nearer hide it
uniform int recoloured;
uniform int turned;      // 1: rows of the ink lie from the top downwards

const float ENOUGH = 4.5;   // contrast of text
const float ROOM = 4.0;     // the same, for which it does not change sides
const float STRONG = 12.0;  // most that greys get which must change: black and white trade places

vec4 look(sampler2D image, vec2 centre, vec2 size) {
#if __VERSION__ >= 130
    return texelFetch(image, ivec2(centre), 0);
#else
    return texture2D(image, centre / size);
#endif
}

vec2 on_canvas(vec2 centre) { return turned == 1 ? vec2(centre.x, ink_size.y - centre.y) : centre; }
vec4 ink_at(vec2 centre) { return look(ink, on_canvas(centre), ink_size); }
vec4 below_at(vec2 centre) { return look(ground, centre, ground_size); }
vec2 within(vec2 place) { return floor(clamp(place, box.xy, box.zw)) + 0.5; }
vec3 linear(vec3 c) { return pow(clamp(c, 0.0, 1.0), vec3(2.2)); }
float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }  // of linear colours

float contrast(float a, float b) { return (max(a, b) + 0.05) / (min(a, b) + 0.05); }

float covered(vec4 own) { return clamp(max(own.a, max(own.r, max(own.g, own.b))), 0.0, 1.0); }

// Luminance of what lies around a place, without the ink: so many pixels to each side.
float around(vec2 at, float reach) {
    float sum = 0.0;
    for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
            vec2 there = at + scale * 0.5 * reach * vec2(i, j);
            sum += luminance(linear(below_at(within(there)).rgb));
        }
    }
    return sum / 25.0;
}

// Whether other ink of the program's lies around ink of a luminance and sets it off: an outline of
// letters, the panel that they stand on.
bool set_off(vec2 at, float own) {
    int found = 0;
    for (int k = 0; k < 8; ++k) {
        float turn = 0.7854 * float(k);
        for (int far = 1; far <= 2; ++far) {
            vec2 there = within(at + scale * 1.5 * float(far) * vec2(cos(turn), sin(turn)));
            vec4 other = ink_at(there);
            float cover = covered(other);
            if (cover < 0.2) continue;
            vec3 seen = other.rgb + (1.0 - cover) * below_at(there).rgb;
            if (contrast(own, luminance(linear(seen))) < 3.0) continue;
            ++found;
            break;
        }
    }
    return found >= 5;
}

// A linear colour with another luminance: the same hue, darker, or lighter by white.
vec3 toned(vec3 c, float own, float wanted) {
    if (wanted <= own) return c * wanted / max(own, 1e-4);
    return mix(c, vec3(1.0), (wanted - own) / max(1.0 - own, 1e-4));
}

vec3 readable(vec3 c, vec2 at) {
    vec3 paint = linear(c);
    float own = luminance(paint), below = around(at, 3.0);
    float now = contrast(own, below);
    if (now >= ENOUGH || set_off(at, own)) return c;
    float most = max(max(paint.r, paint.g), paint.b), least = min(min(paint.r, paint.g), paint.b);
    float grey = 1.0 - (most - least) / max(most, 1e-3);
    float meant = clamp(contrast(own, luminance(linear(home))), ENOUGH, STRONG);
    float enough = mix(ENOUGH, meant, grey * (1.0 - smoothstep(2.5, ENOUGH, now)));
    float darker = (below + 0.05) / enough - 0.05, lighter = (below + 0.05) * enough - 0.05;
    // It stays on its side of the ground if there is room: letter by letter, not pixel by pixel.
    float wide = around(at, 20.0) + 0.05;
    bool up = own + 0.05 > wide ? wide * ROOM <= 1.05 : wide / ROOM < 0.05;
    return pow(toned(paint, own, clamp(up ? lighter : darker, 0.0, 1.0)), vec3(1.0 / 2.2));
}

void main() {
    vec2 at = gl_FragCoord.xy;
    vec4 own = ink_at(at);
    float cover = covered(own);
    if (cover < 0.004) discard;
    float depth = look(ink_depth, on_canvas(at), ink_size).r;
    float surface = tested == 1 ? look(finished_depth, at, depth_size).r : 1.0;
    if (depth > surface + hair) discard;
    vec3 c = own.rgb / cover;
    if (recoloured == 1) c = readable(c, at);
    gl_FragColor = vec4(c * cover, cover);
    gl_FragDepth = depth;
}

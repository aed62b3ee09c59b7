// What:   surfaces lit pixel by pixel, smooth or in flat bands as on a cel.
// Inputs: the G-buffer, the app's finished picture and depth (depth.glsl), the camera, the light.
// Source: Rideout 2010 (per-pixel lighting from the G-buffer, the dragon's cel shader); J. Blinn,
//         "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977.

uniform sampler2D gbuffer;
uniform sampler2D app_colour;
uniform mat4 projection, unprojection;
uniform vec4 viewpoint, viewport;
uniform vec2 range;
uniform vec4 lamp;   // eye space, homogeneous; zero: the viewer's own
uniform vec4 paint;  // alpha 0: the app's
uniform float shine;
uniform float bands; // 0: none

const float AMBIENT = 0.35;
const float HEADLIGHT = 0.3;  // of what the light leaves dark
const float GLOSS = 40.0;
const float PALED = 0.6;      // power of the app's brightness: less of its own shading is left
const float PAINTS = 1.0;     // on a cel, in a ratio of 2
const float AIRBRUSHED = 0.25; // of what these leave out: tiles of like paints stay apart
const float CREASED = 0.25;   // change of a normal from one pixel to the next
const float BENT = 2.0;       // pixels by which a quad's diagonals may part

vec4 drawn(vec2 place) { return texelFetch(gbuffer, ivec2(clamp(place, port.xy, port.zw)), 0); }

// Depth that the surface gains in a pixel; the lesser of both sides, as the other may be beyond it.
float slope(vec2 at, vec2 aside, float depth) {
    return min(abs(drawn(at + aside).a - depth), abs(drawn(at - aside).a - depth));
}

// A value in steps, smooth over so much of one as a pixel spans.
float stepped(float level, float blur) {
    return floor(level) + smoothstep(1.0 - max(blur, 1e-3), 1.0, fract(level));
}

// Eye space of a place in the window, and the way back for the depth alone.
vec3 place(vec2 at, float depth) {
    float reach = range.y == range.x ? 1.0 : range.y - range.x;
    vec4 found = unprojection * vec4((at - viewport.xy) / viewport.zw,
                                     2.0 * (depth - range.x) / reach - 1.0, 1.0);
    return found.xyz / found.w;
}

float depth_of(vec3 spot) {
    vec4 found = projection * vec4(spot, 1.0);
    return mix(range.x, range.y, 0.5 * found.z / found.w + 0.5);
}

// The app's colour without most of its shading; on a cel one of a few paints.
vec3 painted(vec3 shown) {
    float value = max(max(shown.r, shown.g), shown.b), level = log2(max(value, 0.01));
    if (bands > 0.0) level = mix(floor(PAINTS * level + 0.5) / PAINTS, level, AIRBRUSHED);
    return shown / max(value, 1e-3) * min(exp2(PALED * level), 1.0);
}

void main() {
    vec2 at = gl_FragCoord.xy;
    vec4 here = drawn(at);
    vec3 n = here.xyz;
    vec3 spot = place(at, away * here.a);
    vec3 sight = normalize(viewpoint.xyz - viewpoint.w * spot);
    vec3 to_light = lamp.xyz - lamp.w * spot;
    to_light = dot(to_light, to_light) > 0.0 ? normalize(to_light) : sight;
    float lit = max(dot(n, to_light), 0.0), seen = max(dot(n, sight), 0.0);
    float bright = max(lit, HEADLIGHT * seen);
    vec3 middle = normalize(to_light + sight);
    float gleam = lit > 0.0 ? pow(max(dot(n, middle), 0.0), GLOSS) : 0.0;
    // A flat face under parallel light, seen in parallel, would shine as a whole.
    if (length(fwidth(n)) + length(fwidth(middle)) < 1e-5) gleam = 0.0;

    // What the app drew besides its meshes, or over them, stays. Drivers cut a quad that is not
    // flat along either diagonal.
    float steep = slope(at, vec2(1.0, 0.0), here.a) + slope(at, vec2(0.0, 1.0), here.a);
    float pixel = distance(place(at + vec2(1.0, 0.0), away * here.a), spot);
    float deep = abs(depth_of(spot - pixel * sight) - away * here.a);
    float gap = abs(finished(at) - away * here.a);
    bool own = gap <= hair + (0.25 + blur) * steep + BENT * deep;

    vec3 shown = texelFetch(app_colour, ivec2(at), 0).rgb;
    vec3 base = paint.a > 0.0 ? paint.rgb : painted(shown);
    if (bands > 0.0) {
        float blur = length(fwidth(n)) > CREASED ? 0.0 : min(bands * fwidth(bright), 0.5);
        bright = min(stepped(bands * bright, blur), bands - 1.0) / (bands - 1.0);
        gleam = smoothstep(-0.5, 0.5, (gleam - 0.5) / max(fwidth(gleam), 1e-4));
    }
    if (dot(n, n) == 0.0 || !own) discard;
    float shade = AMBIENT + (1.0 - AMBIENT) * bright;
    colour = vec4(min(base * shade + shine * gleam, 1.0), 1.0);
}

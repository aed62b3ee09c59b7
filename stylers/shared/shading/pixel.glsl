// What:   what light on a pixel needs: its surface's place and normal, and whether it is seen
//         there.
// Inputs: fog.glsl, the G-buffer, the app's finished picture and depth (depth.glsl), the camera.
// Source: P. Rideout, "Silhouette Extraction", 2010 (per-pixel lighting from the G-buffer).

uniform sampler2D gbuffer;
uniform sampler2D app_colour;
uniform mat4 projection, unprojection;
uniform vec4 viewpoint, viewport;
uniform vec2 range;

const float CREASED = 0.25;   // change of a normal from one pixel to the next
#ifndef BENT
#define BENT 2.0              // pixels by which a quad's diagonals may part
#endif

struct Pixel {
    vec3 n;       // unit normal, eye space, turned to the viewer; zero where no surface is
    vec3 lit;     // the same, to the side that GL lights
    vec3 spot;    // eye space
    vec3 sight;   // unit vector to the viewer
    vec3 shown;   // the app's colour, without its fog
    float clear;  // share of that which is seen through the fog
    bool own;     // the surface of the G-buffer is what the app shows
    bool gleams;  // the app's material does
    bool crisp;   // a crease, or another surface, lies within a pixel
};

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

// The pixel that is drawn. Takes derivatives: before any discard.
Pixel this_pixel() {
    vec2 at = gl_FragCoord.xy;
    vec4 here = drawn(at);
    float size = floor(length(here.xyz) + 0.5);
    vec3 n = size > 0.0 ? normalize(here.xyz) : vec3(0.0);
    vec3 lit = size > 2.5 ? -n : n;
    vec3 spot = place(at, away * here.a);
    vec3 sight = normalize(viewpoint.xyz - viewpoint.w * spot);
    // What the app drew besides its meshes, or over them, stays. Drivers cut a quad that is not
    // flat along either diagonal.
    float steep = slope(at, vec2(1.0, 0.0), here.a) + slope(at, vec2(0.0, 1.0), here.a);
    float pixel = distance(place(at + vec2(1.0, 0.0), away * here.a), spot);
    float deep = abs(depth_of(spot - pixel * sight) - away * here.a);
    float gap = abs(finished(at) - away * here.a);
    bool own = size > 0.0 && gap <= hair + (0.25 + blur) * steep + BENT * deep;
    float clear = clear_share(spot);
    vec3 shown = without_fog(texelFetch(app_colour, ivec2(at), 0).rgb, clear);
    return Pixel(n, lit, spot, sight, shown, clear, own,
                 mod(size, 2.0) == 0.0, length(fwidth(n)) + length(fwidth(lit)) > 2.0 * CREASED);
}

// What:   ink on a quad, as much as it covers of a pixel, where its line is seen.
// Inputs: stroke.glsl; the quad (quads.glsl).
// Source: Hajagos et al. 2012, sections 4.2 and 5.

uniform vec3 ink;
uniform float half_width;
uniform float bias;         // pixels' worth of depth by which a line may lie behind what is drawn
uniform float fade;         // the same over which it fades away beyond that
uniform int spine;          // 1: the depth of a crease's middle decides, too
uniform int back_faces;     // 1: contours are hidden by back faces alone, which are in the G-buffer
uniform sampler2D gbuffer;  // alpha: depth of back faces; 0: none
uniform int textured;       // 1: ink from the texture, 2: with its own colours
uniform sampler2D stroke;   // along, and across with the inside in its first row
uniform float repeat;       // pixels after which the texture repeats

const float LEAN = 1.5;     // pixels' worth of depth by which a surface may rise in each pixel

noperspective in vec3 spot;
flat in int on_surface;

// Share of what is drawn of a place behind so much depth (section 5).
float soft(float behind, float most) {
    float over = (behind - hair) / grain.x - most;
    return fade > 0.0 ? clamp(1.0 - over / fade, 0.0, 1.0) : over <= 0.0 ? 1.0 : 0.0;
}

float shown(float on) {
    if (on_surface == 1) {
        // Where the surface is bent it rises out of the triangle's plane.
        float most = bias + blur + (spine == 1 ? LEAN * abs(spot.y) : 0.0);
        float share = soft(spot.z - finished(gl_FragCoord.xy), most);
        return share > 0.0 && spine == 1 && !seen(on) ? 0.0 : share;
    }
    if (back_faces == 0 || kind != CONTOUR) return seen(on) ? 1.0 : 0.0;
    vec3 at = point(on);
    vec2 centre = clamp(at.xy, port.xy, port.zw);
    float behind = texelFetch(gbuffer, ivec2(centre), 0).a;
    return behind == 0.0 ? 1.0 : soft(at.z - away * behind, bias + 1.0);
}

void main() {
    take_stroke();
    // Joined lines share the circle around their join as well.
    float on = clamp(spot.x, 0.0, span), d = length(vec2(spot.x - on, spot.y));
    float cover = clamp(half_width + 0.5 - d, 0.0, 1.0);
    vec4 drawn = vec4(ink, 1.0);
    if (textured > 0) {
        // Cut out of the screen: the contour in a triangle does not know how long it is before it.
        vec2 along_it = abs(along.y) > abs(along.x) ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
        float v = 0.5 + 0.5 * spot.y / half_width;
        vec4 found = texture(stroke, vec2(dot(gl_FragCoord.xy + sheet.xy, along_it) / repeat, v));
        drawn = textured == 2 ? found : vec4(ink * found.a, found.a);
    }
    if (cover > 0.0) cover *= drawn.a > 0.0 ? shown(on) : 0.0;
    if (cover <= 0.0) discard;
    colour = cover * drawn;
}

// What:   ink on a quad of a few pixels, whose line the geometry shader has found to be seen.
// Inputs: the finished depth (depth.glsl); the quad (quads.glsl, SHORT_LINES).
// Source: Hajagos et al. 2012, sections 4.2 and 5.

uniform vec3 ink;
uniform float half_width;
uniform float bias;     // pixels' worth of depth by which a line may lie behind what is drawn
uniform float fade;     // the same over which it fades away beyond that

noperspective in vec3 spot;
flat in vec3 edge;      // its length, depth of a pixel at 45 degrees, 1 if it lies on its triangle

const float LEAN = 1.5;  // pixels' worth of depth by which a surface may rise in each pixel

void main() {
    float past = spot.x - clamp(spot.x, 0.0, edge.x);
    float cover = clamp(half_width + 0.5 - length(vec2(past, spot.y)), 0.0, 1.0);
    if (edge.z > 0.0) {
        float over = (spot.z - finished(gl_FragCoord.xy) - hair) / edge.y;
        over -= bias + blur + LEAN * abs(spot.y);
        cover *= fade > 0.0 ? clamp(1.0 - over / fade, 0.0, 1.0) : step(over, 0.0);
    }
    colour = vec4(cover * ink, cover);
}

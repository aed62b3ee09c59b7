// What:   ink on a fin, smooth at its rim, where its spine is seen.
// Inputs: stroke.glsl; the fin (fins.geom.glsl).
// Source: Rideout 2010, "Antialiased Fins", "The Spine Test" (F. Cole, A. Finkelstein 2010).

uniform vec3 ink;
uniform float half_width;
uniform float tip;      // pixels over which the ink fades at the rim; 0: none
uniform int spine;      // 1: the depth of the middle decides for all of the width
uniform int joints;

noperspective in vec3 reach;
flat in float decided;  // 1: a short fin, of which the geometry shader knows that it is seen

const int ROUND_JOINTS = 2;

void main() {
    take_stroke();
    float on = clamp(reach.x, 0.0, span);
    float d = joints == ROUND_JOINTS ? length(vec2(reach.x - on, reach.y)) : abs(reach.y);
    // Of the signed distance, which has no kink at the spine, and by its direction: fwidth adds up
    // the changes along x and y.
    float fade = tip * fwidth(reach.y) / (abs(along.x) + abs(along.y));
    float alpha = d > half_width ? 0.0 : 1.0;
    if (fade > 0.0) alpha = clamp((half_width - d) / fade, 0.0, 1.0);
    if (alpha <= 0.0) discard;
    // Of five places about this one (`seen`) none lies beyond an end: caps are as their fin is.
    if (spine == 0) {
        if (finished(gl_FragCoord.xy) < reach.z - hair) discard;
    } else if (decided == 0.0 && !seen(clamp(on, 2.0, span - 2.0))) discard;
    colour = vec4(alpha * ink, alpha);
}

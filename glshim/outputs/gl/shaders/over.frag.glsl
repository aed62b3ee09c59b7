// What:   the gathered ink, pixel for pixel, without lonely specks: what occlusion leaves of a line
//         here and there.
//         GLSL 1.20 and, with faster look-ups, 1.30.
// Inputs: ink (premultiplied), as large as the viewport; box: least and greatest pixel centre;
//         size: pixels of ink; without TIDY specks stay (a pattern may be made of them).
uniform sampler2D ink;
uniform vec4 box;
uniform vec2 size;

const float FAINT = 0.1;   // less ink than that joins nothing

vec4 ink_at(vec2 centre) {
#if __VERSION__ >= 130
    return texelFetch(ink, ivec2(centre), 0);
#else
    return texture2D(ink, centre / size);
#endif
}

float inked(vec2 step) {
    return float(ink_at(clamp(gl_FragCoord.xy + step, box.xy, box.zw)).a > FAINT);
}

// Inked pixels at a distance of so many columns or rows.
float ring(float distance) {
    float count = 0.0;
    for (float k = -3.0; k < 3.5; k += 1.0) {
        if (abs(k) > distance) continue;
        count += inked(vec2(k, distance)) + inked(vec2(k, -distance));
        if (abs(k) < distance) count += inked(vec2(distance, k)) + inked(vec2(-distance, k));
    }
    return count;
}

// Inked pixels two columns or rows away that touch an inked pixel beside this one.
float linked() {
    float count = 0.0;
    for (float x = -2.0; x < 2.5; x += 1.0) {
        for (float y = -2.0; y < 2.5; y += 1.0) {
            if (max(abs(x), abs(y)) < 1.5 || inked(vec2(x, y)) == 0.0) continue;
            float touched = 0.0;
            for (float i = -1.0; i < 1.5; i += 1.0) {
                for (float j = -1.0; j < 1.5; j += 1.0) {
                    vec2 at = vec2(x + i, y + j);
                    float away = max(abs(at.x), abs(at.y));
                    if (away > 0.5 && away < 1.5) touched += inked(at);
                }
            }
            count += min(touched, 1.0);
        }
    }
    return count;
}

// Whether a pixel belongs to a speck of up to three pixels, or of five with nothing about them.
bool lonely() {
    float beside = ring(1.0);
    if (beside > 3.5) return false;
    if (beside == 0.0 || beside < 2.5 && beside + linked() < 2.5) return true;
    return beside + ring(2.0) < 4.5 && ring(3.0) == 0.0;
}

void main() {
    gl_FragColor = ink_at(gl_FragCoord.xy);
    if (gl_FragColor.a == 0.0) discard;
#ifdef TIDY
    if (lonely()) discard;
#endif
}

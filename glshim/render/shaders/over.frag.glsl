#version 120
// What:   the gathered ink, pixel for pixel, without lonely specks: what occlusion leaves of a line
//         here and there.
// Inputs: ink (premultiplied), as large as the viewport; box: least and greatest pixel centre;
//         size: pixels of ink; tidy: 0 leaves specks (a pattern may be made of them).
uniform sampler2D ink;
uniform vec4 box;
uniform vec2 size;
uniform float tidy;
varying vec2 place;

const float FAINT = 0.1;   // less ink than that joins nothing

float inked(vec2 step) {
    return float(texture2D(ink, clamp(place * size + step, box.xy, box.zw) / size).a > FAINT);
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

bool lonely() {
    float beside = ring(1.0);
    if (beside > 3.5) return false;
    float around = ring(2.0);
    return around == 0.0 || beside == 0.0 || beside + around < 5.0 && ring(3.0) == 0.0;
}

void main() {
    gl_FragColor = texture2D(ink, place);
    if (gl_FragColor.a == 0.0 || tidy > 0.0 && lonely()) discard;
}

// What:   the motion of a hand along its stroke. For both stages, after stroke.glsl.
// Inputs: where on its pattern a line lies (repeats), which it keeps from frame to frame.
// Source: NPRQuake's sketch and blueprint: jittered translucent lines, and lines that overshoot.
//         There each polygon's side jitters by itself; here what a hand draws in one go does.

PASSED vec4 hand;           // pixels of the stroke before a, after b; beyond its ends; seen whole

uniform float wobble;       // pixels by which the hand strays
uniform float period;       // pixels of a stroke after which its motion repeats
uniform float overshoot;    // pixels beyond the ends of a stroke
uniform float overshoot_share;  // of its length, at most
uniform float jitter_seed;  // a number for each motion of the hand

const float TURN = 6.2831853;
const float WHOLE = 60.0;   // pixels of the window of a stroke that strays in full
const float AT_END = 0.02;  // pixels

float chance(float n) { return fract(sin(12.9898 * n + 78.233 * jitter_seed) * 43758.5453); }

// Smooth, -1..1 mostly, the same after each repeat.
float motion(float at, float which) {
    float found = 0.0;
    for (float k = 1.0; k < 5.5; k += 1.0)
        found += sin(TURN * (k * at + chance(which + k))) / (1.0 + 0.6 * k);
    return 0.62 * found;
}

// Repeats of the pattern at t pixels along.
float repeat_at(float t) { return mix(repeats.x, repeats.y, t / span); }

// Which way the stroke runs: +1 from a to b.
float way() { return repeats.y < repeats.x ? -1.0 : 1.0; }

// Pixels that the whole stroke is long, of those that count.
float stroke_length() { return min(hand.x + span + hand.y, 1e5); }

// How much of its motions a short stroke makes, or one around which they are squeezed.
float share_of_motion() {
    float squeezed = period * abs(repeats.y - repeats.x) / span;
    return min(stroke_length() / (WHOLE * shot.z), 1.0) / max(squeezed, 1.0);
}

// Pixels to the right of the line, on which side the hand is at t.
float strays(float t) {
    return way() * wobble * share_of_motion() * motion(repeat_at(t), 3.0);
}

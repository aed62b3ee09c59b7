// What:   flat bands of the app's own shading, as painted on a cel.
// Inputs: tone.glsl.
// Source: A. Lake et al., "Stylized Rendering Techniques for Scalable Real-Time 3D Animation", NPAR
//         2000. Bands lie in equal ratios of brightness, so that dark and light paints alike have
//         two or three of them.

const float BANDS = 1.9;  // in a ratio of 2

const float WHITES = 4.0;
const float AIRBRUSHED = 0.2;  // of what bands leave out: tiles of like paints stay apart

// A value in steps of 1, each at its middle, smooth over a pixel.
float stepped(float level) {
    float blur = clamp(0.7 * fwidth(level), 0.02, 0.5);
    return floor(level) + smoothstep(1.0 - blur, 1.0, fract(level)) + 0.5;
}

void main() {
    vec2 at = gl_FragCoord.xy;
    if (!surface(at)) {
        if (behind == 0) discard;
        colour = vec4(paper, 1.0);
        return;
    }
    vec3 paint = shown(at);
    float value = max(max(paint.r, paint.g), paint.b);
    float level = BANDS * log2(max(value, 0.04));
    float flatly = exp2(mix(stepped(level), level, AIRBRUSHED) / BANDS);
    vec3 hue = paint / max(value, 1e-3);
    // Highlights, which are whiter than the paint, are flat too.
    float white = min(min(hue.r, hue.g), hue.b);
    float flat_white = mix(stepped(WHITES * white) / WHITES, white, smoothstep(0.5, 0.7, white));
    hue = 1.0 - (1.0 - hue) * (1.0 - flat_white) / max(1.0 - white, 0.05);
    hue = pow(clamp(hue, 0.0, 1.0), vec3(1.12));  // paint from a pot is purer
    colour = vec4(hue * min(1.1 * flatly + 0.03, 1.0), 1.0);
}

// What:   flat bands of the app's own shading, as painted on a cel.
// Inputs: tone.glsl.
// Source: A. Lake et al., "Stylized Rendering Techniques for Scalable Real-Time 3D Animation", NPAR
//         2000. Bands lie in equal ratios of brightness, so that dark and light paints alike have two
//         or three of them.

const float BANDS = 2.2;  // in a ratio of 2

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
    float blur = clamp(0.7 * fwidth(level), 0.02, 0.5);
    float band = floor(level) + smoothstep(1.0 - blur, 1.0, fract(level)) + 0.5;
    float flatly = exp2(band / BANDS);
    vec3 hue = paint / max(value, 1e-3);
    hue = pow(hue, vec3(1.25));  // paint from a pot is purer
    colour = vec4(clamp(hue * min(1.12 * flatly + 0.04, 1.0), 0.0, 1.0), 1.0);
}

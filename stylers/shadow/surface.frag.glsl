// What:   surfaces of the app's as the stencil compares them: a little off the depth that the fixed
//         function gave them. Its last bits may be others, and so may its place in the pixel
//         (blur).
// Inputs: which way, +1 is away from the viewer; by how many pixels' slope.
uniform float push;
uniform float slack;   // pixels

void main() {
    gl_FragDepth = gl_FragCoord.z
                 + push * away * (hair + (slack + blur) * fwidth(gl_FragCoord.z));
    colour = vec4(0.0);
}

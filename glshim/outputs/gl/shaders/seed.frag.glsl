#version 130
// What:   the layer's finished depth, pixel for pixel, into a depth buffer of ours.
// Inputs: that depth, as it is.
uniform sampler2D finished_depth;
void main() {
    gl_FragDepth = texelFetch(finished_depth, ivec2(gl_FragCoord.xy), 0).r;
}

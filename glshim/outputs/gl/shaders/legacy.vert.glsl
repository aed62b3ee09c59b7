// What:   a vertex that the CPU has expanded, and what its line passes to fragments. GLSL 1.20.
// Inputs: place in clip space; DECLARED: an attribute and a varying each; COPIED: their copies.
attribute vec2 place;
DECLARED
void main() {
    gl_Position = vec4(place, 0.0, 1.0);
    COPIED
}

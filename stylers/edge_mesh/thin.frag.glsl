// What:   ink.
// Inputs: its colour.
// Source: McGuire & Hughes 2004, section 3.2.
flat in vec3 ink_here;

void main() {
    colour = vec4(ink_here, 1.0);
}

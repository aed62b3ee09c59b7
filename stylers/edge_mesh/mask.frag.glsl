// What:   nothing but what the stencil does.
void main() {
    colour = vec4(0.0);
}

// What:   the shadow.
// Inputs: its colour and share.
uniform vec4 shade;   // premultiplied

void main() { colour = shade; }

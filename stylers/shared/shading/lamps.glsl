// What:   the light that falls on a surface from lamps: the app's GL_LIGHTs, or the style's own.
// Inputs: glshim/model/lights.py, in whose order they come.
// Source: The OpenGL Specification, version 2.1, section 2.14.1. Numpy reference: the same module's
//         `incoming`. Highlights: J. Blinn, "Models of Light Reflection for Computer Synthesized
//         Pictures", SIGGRAPH 1977.

uniform int lamps;
uniform vec4 lamp_place[8];  // eye space, homogeneous; zero: the viewer's own
uniform vec3 lamp_shade[8];  // diffuse
uniform vec3 lamp_gleam[8];  // specular
uniform vec3 lamp_fade[8];   // attenuation
uniform vec4 lamp_beam[8];   // unit direction of a spot light, cosine of its cut-off; -1: all round
uniform float lamp_focus[8]; // its exponent

struct Falling {
    vec3 way;     // unit vector to the lamp
    float share;  // of its light that reaches the place: attenuation and beam
};

Falling falling(int k, Pixel p) {
    vec4 lamp = lamp_place[k];
    vec3 way = lamp.xyz - lamp.w * p.spot;
    float reach = length(way);
    Falling f = Falling(reach > 0.0 ? way / reach : p.sight, 1.0);
    if (lamp.w != 0.0) {
        reach /= abs(lamp.w);
        f.share /= max(dot(lamp_fade[k], vec3(1.0, reach, reach * reach)), 1e-30);
    }
    if (lamp_beam[k].w >= 0.0) {
        float along = -dot(f.way, lamp_beam[k].xyz);
        f.share *= along >= lamp_beam[k].w ? pow(max(along, 1e-30), lamp_focus[k]) : 0.0;
    }
    return f;
}

// Diffuse light.
vec3 incoming(Pixel p) {
    vec3 found = vec3(0.0);
    for (int k = 0; k < lamps; ++k) {
        Falling f = falling(k, p);
        found += f.share * max(dot(p.lit, f.way), 0.0) * lamp_shade[k];
    }
    return found;
}

// Whether a surface is bent there: a flat face under parallel light would shine as a whole.
bool is_bent(Pixel p) { return !p.crisp && length(fwidth(p.n)) > 1e-4; }

// Highlights, of materials that gleam white.
vec3 gleaming(Pixel p, float gloss) {
    vec3 found = vec3(0.0);
    for (int k = 0; k < lamps; ++k) {
        Falling f = falling(k, p);
        float facing = dot(p.lit, f.way);
        float gleam = pow(max(dot(p.lit, normalize(f.way + p.sight)), 0.0), gloss);
        if (facing > 0.0) found += f.share * gleam * lamp_gleam[k];
    }
    return found;
}

// Prelude of every line shader: the line record.
// Source: glshim/model/lines.py, Line.

layout(location = 0) in vec3 edge_a;      // eye space: the side runs from a
layout(location = 1) in vec3 edge_b;      // to b, its polygon on the left in the window;
layout(location = 2) in vec3 edge_c;      // where an outline goes on from b, or b
layout(location = 3) in vec3 edge_own;    // unit normal of its polygon, of the winding along a to b
layout(location = 4) in vec3 edge_other;  // of the other polygon on the edge, or 0
layout(location = 5) in vec3 edge_kind;   // RING ...; repeats of a pattern at a and at b
layout(location = 6) in vec3 edge_hand;   // pixels of its stroke before a, after b; its number

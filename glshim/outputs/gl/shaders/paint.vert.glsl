#version 120
// What:   the app's polygon exactly where the fixed function puts it, in its paint, without light.
// Inputs: gl_Vertex, gl_Color, the materials, texture matrices and texture generation of GL.
// Source: The OpenGL Specification, version 2.1, sections 2.11.4 (texture coordinates), 2.14.

uniform bool lit;
uniform int tracked;     // 1: the front's diffuse material is gl_Color, 2: the back's
uniform bool two_sided;
uniform bool fog_given;  // fog by gl_FogCoord, else by distance
uniform ivec4 made[4];   // texture coordinates s, t, r, q of each unit: GIVEN or how they are made

uniform int normalised;  // 1: GL_NORMALIZE, 2: GL_RESCALE_NORMAL

const int GIVEN = 0, OBJECT = 1, EYE = 2, SPHERE = 3, REFLECTION = 4, NORMAL = 5;

float coordinate(int way, float given, int k, vec4 eye, vec3 n, vec4 object, vec4 plane) {
    if (way == GIVEN) return given;
    if (way == OBJECT) return dot(gl_Vertex, object);
    if (way == EYE) return dot(eye, plane);
    if (way == NORMAL) return n[k];
    vec3 r = reflect(normalize(eye.xyz), n);
    if (way == REFLECTION) return r[k];
    float m = 2.0 * sqrt(dot(r.xy, r.xy) + (r.z + 1.0) * (r.z + 1.0));
    return r[k] / m + 0.5;
}

vec4 generated(int unit, vec4 given, vec4 eye, vec3 n) {
    ivec4 way = made[unit];
    return vec4(
        coordinate(way.x, given.x, 0, eye, n, gl_ObjectPlaneS[unit], gl_EyePlaneS[unit]),
        coordinate(way.y, given.y, 1, eye, n, gl_ObjectPlaneT[unit], gl_EyePlaneT[unit]),
        coordinate(way.z, given.z, 2, eye, n, gl_ObjectPlaneR[unit], gl_EyePlaneR[unit]),
        coordinate(way.w, given.w, 0, eye, n, gl_ObjectPlaneQ[unit], gl_EyePlaneQ[unit]));
}

vec4 placed(int unit, vec4 given, vec4 eye, vec3 n) {
    vec4 found = made[unit] == ivec4(GIVEN) ? given : generated(unit, given, eye, n);
    return gl_TextureMatrix[unit] * found;
}

void main() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    vec3 n = gl_NormalMatrix * gl_Normal;
    if (normalised == 1) n = normalize(n);
    if (normalised == 2) n *= gl_NormalScale;
    gl_Position = ftransform();
    gl_ClipVertex = eye;
    vec4 front = gl_Color, back = gl_Color;
    if (lit) {
        if (tracked != 1 && tracked != 3) front = gl_FrontMaterial.diffuse;
        if (tracked < 2) back = gl_BackMaterial.diffuse;
        front.rgb += gl_FrontMaterial.emission.rgb;
        back.rgb += gl_BackMaterial.emission.rgb;
    }
    gl_FrontColor = clamp(front, 0.0, 1.0);
    gl_BackColor = clamp(two_sided ? back : front, 0.0, 1.0);
    gl_FrontSecondaryColor = gl_BackSecondaryColor = lit ? vec4(0.0) : gl_SecondaryColor;
    gl_TexCoord[0] = placed(0, gl_MultiTexCoord0, eye, n);
    gl_TexCoord[1] = placed(1, gl_MultiTexCoord1, eye, n);
    gl_TexCoord[2] = placed(2, gl_MultiTexCoord2, eye, n);
    gl_TexCoord[3] = placed(3, gl_MultiTexCoord3, eye, n);
    gl_FogFragCoord = fog_given ? gl_FogCoord : abs(eye.z);
}

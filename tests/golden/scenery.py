"""An ordinary program with surfaces as programs make them: `python scenery.py SCENE`.

Floors under glNormal's default, materials inside glBegin, glass, fog, and ground without depth.
"""

import sys

import pygame
from OpenGL.GL import *  # noqa: F403
from OpenGL.GLU import (
    GLU_FLAT,
    GLU_SMOOTH,
    gluDeleteQuadric,
    gluLookAt,
    gluNewQuadric,
    gluPerspective,
    gluQuadricNormals,
    gluSphere,
)

# ruff: noqa: F405

WIDTH, HEIGHT = 400, 300
SKY = (0.45, 0.6, 0.85)


def look(eye, at=(0.0, 0.0, 0.0), sky=SKY):
    glClearColor(*sky, 1.0)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glViewport(0, 0, WIDTH, HEIGHT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(50.0, WIDTH / HEIGHT, 0.1, 3000.0)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(*eye, *at, 0.0, 1.0, 0.0)


def light(place=(0.0, 300.0, 0.0, 1.0), number=GL_LIGHT0, colour=(1.0, 1.0, 1.0)):
    glEnable(GL_LIGHTING)
    glEnable(number)
    glLightfv(number, GL_POSITION, place)
    glLightfv(number, GL_DIFFUSE, (*colour, 1.0))


def plane(x, z, width, depth, y=0.0):
    """Level, from a corner."""
    for u, v in ((0, 0), (0, 1), (1, 1), (1, 0)):
        glVertex3f(x + u * width, y, z + v * depth)


def floor(normal):
    """A road to the horizon."""
    look((0.0, 60.0, 100.0), (0.0, 40.0, -100.0))
    light()
    glEnable(GL_COLOR_MATERIAL)
    glNormal3f(*normal)
    glColor3f(0.6, 0.6, 0.6)
    glBegin(GL_QUADS)
    plane(-80.0, -900.0, 160.0, 950.0)
    glEnd()


def floor_with_gls_normal():
    floor((0.0, 0.0, 1.0))


def floor_with_its_own():
    floor((0.0, 1.0, 0.0))


PAPER, STONE = (0.9, 0.85, 0.7, 1.0), (0.25, 0.35, 0.3, 1.0)


def chequers(shade):
    """A chequered floor in one primitive; shade: called with a colour inside it."""
    glNormal3f(0.0, 1.0, 0.0)
    glBegin(GL_QUADS)
    for i in range(8):
        for k in range(8):
            shade(PAPER if (i + k) % 2 else STONE)
            plane(i - 4.0, k - 4.0, 1.0, 1.0)
    glEnd()


def material(shade):
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, shade)


def room():
    look((0.0, 4.0, 6.0))
    light((2.0, 5.0, 3.0, 0.0))
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, (0.2, 0.2, 0.8, 1.0))


def compiled(content):
    glNewList(7, GL_COMPILE)
    content()
    glEndList()
    glCallList(7)


def chequers_of_material():
    room()
    chequers(material)


def chequers_of_colour():
    room()
    glEnable(GL_COLOR_MATERIAL)
    chequers(lambda shade: glColor4f(*shade))


def chequers_of_material_in_a_list():
    room()
    compiled(chequers_of(material))


def chequers_of_colour_in_a_list():
    room()
    glEnable(GL_COLOR_MATERIAL)
    compiled(chequers_of(lambda shade: glColor4f(*shade)))


def chequers_in_a_list_that_says_how():
    """It turns glColorMaterial on by itself."""

    def content():
        glEnable(GL_COLOR_MATERIAL)
        chequers(lambda shade: glColor4f(*shade))
        glDisable(GL_COLOR_MATERIAL)

    room()
    compiled(content)


def chequers_of(shade):
    return lambda: chequers(shade)


GRASS, HILLS, ROAD = (0.3, 0.55, 0.2), (0.45, 0.5, 0.4), (0.35, 0.35, 0.38)


def road(depth_test):
    """Grass and hills lie behind all, without depth; the road and a house are solid."""
    look((0.0, 5.0, 12.0), (0.0, 1.0, 0.0))
    glDepthMask(GL_FALSE)
    (glEnable if depth_test else glDisable)(GL_DEPTH_TEST)
    glColor3f(*HILLS)
    glBegin(GL_TRIANGLES)
    for x in (-90.0, -20.0, 50.0):
        for dx, y in ((-40.0, 0.0), (40.0, 0.0), (0.0, 18.0)):
            glVertex3f(x + dx, y, -100.0)
    glEnd()
    glColor3f(*GRASS)
    glBegin(GL_QUADS)
    plane(-200.0, -100.0, 400.0, 120.0, -0.02)
    glEnd()
    glDepthMask(GL_TRUE)
    glEnable(GL_DEPTH_TEST)
    light((2.0, 5.0, 4.0, 0.0))
    glEnable(GL_COLOR_MATERIAL)
    glColor3f(*ROAD)
    glNormal3f(0.0, 1.0, 0.0)
    glBegin(GL_QUADS)
    plane(-2.0, -90.0, 4.0, 110.0)
    glEnd()
    glColor3f(0.8, 0.4, 0.3)
    box((-4.5, 1.0, -1.0), 1.0)


def box(middle, size):
    glBegin(GL_QUADS)
    for axis in range(3):
        for side in (-1, 1):
            normal = [0.0, 0.0, 0.0]
            normal[axis] = side
            glNormal3f(*normal)
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))[::side]:
                point = [0.0, 0.0, 0.0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, a, b
                glVertex3f(*(m + size * p for m, p in zip(middle, point, strict=True)))
    glEnd()


def road_without_depth_writes():
    road(depth_test=True)


def road_without_depth_test():
    road(depth_test=False)


def blended():
    """On black: a faint net, a pane of glass without depth, and a box behind both."""
    look((0.0, 2.0, 7.0), sky=(0.0, 0.0, 0.0))
    light((2.0, 5.0, 4.0, 0.0))
    glEnable(GL_COLOR_MATERIAL)
    glColor3f(0.8, 0.4, 0.3)
    box((-1.2, 0.0, -1.0), 1.0)
    glDisable(GL_LIGHTING)
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
    glDepthMask(GL_FALSE)
    glColor4f(1.0, 1.0, 1.0, 0.2)
    glBegin(GL_QUADS)
    for k in range(9):  # broad lines, as polygons
        plane(0.5 * k - 2.0, -2.0, 0.08, 4.0, -1.2)
    glEnd()
    glColor4f(0.2, 0.5, 0.9, 0.4)
    glBegin(GL_QUADS)
    for x, y in ((-0.8, -1.0), (1.8, -1.0), (1.8, 1.0), (-0.8, 1.0)):
        glVertex3f(x, y, 1.5)
    glEnd()


def ball(radius):
    quadric = gluNewQuadric()
    gluSphere(quadric, radius, 32, 24)
    gluDeleteQuadric(quadric)


def glass(writes):
    """A blue glass ball before a chequered floor and a box."""
    look((0.0, 2.0, 7.0), sky=(0.9, 0.9, 0.9))
    light((2.0, 5.0, 4.0, 0.0))
    glEnable(GL_COLOR_MATERIAL)
    glPushMatrix()
    glTranslatef(0.0, -1.0, 0.0)
    chequers(lambda shade: glColor4f(*shade))
    glPopMatrix()
    glColor3f(0.8, 0.4, 0.3)
    box((-1.2, 0.0, -1.0), 1.0)
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
    glDepthMask(GL_TRUE if writes else GL_FALSE)
    glEnable(GL_CULL_FACE)
    glColor4f(0.2, 0.4, 0.9, 0.4)
    glTranslatef(0.4, 0.4, 2.0)
    ball(1.2)


def glass_without_depth():
    glass(writes=False)


def glass_with_depth():
    glass(writes=True)


def in_fog():
    """Boxes that go into fog of the sky's colour."""
    look((0.0, 2.0, 7.0), sky=(0.75, 0.8, 0.85))
    light((2.0, 5.0, 4.0, 0.0))
    glEnable(GL_FOG)
    glFogi(GL_FOG_MODE, GL_LINEAR)
    glFogf(GL_FOG_START, 4.0)
    glFogf(GL_FOG_END, 26.0)
    glFogfv(GL_FOG_COLOR, (0.75, 0.8, 0.85, 1.0))
    glEnable(GL_COLOR_MATERIAL)
    glColor3f(0.35, 0.5, 0.3)
    glNormal3f(0.0, 1.0, 0.0)
    glBegin(GL_QUADS)
    plane(-20.0, -40.0, 40.0, 45.0, -1.0)
    glEnd()
    glColor3f(0.8, 0.3, 0.2)
    for k in range(6):
        box((-3.0 + 1.6 * k, 0.0, 2.0 - 4.0 * k), 1.0)


def coloured_lamps():
    look((0.0, 2.0, 7.0), sky=(0.9, 0.9, 0.9))
    for k, colour in enumerate(((1.0, 0.1, 0.1), (0.1, 1.0, 0.1), (0.1, 0.2, 1.0))):
        light(((-4.0, 3.0, 3.0, 0.0), (0.0, 5.0, 2.0, 0.0), (4.0, 2.0, 3.0, 0.0))[k],
              GL_LIGHT0 + k, colour)
    material((0.8, 0.8, 0.8, 1.0))
    ball(1.6)
    box((-3.2, -0.5, 0.0), 0.9)


def lamps_that_change():
    """Red light for one ball, green for the next, and a view with a blue one."""
    look((0.0, 2.0, 7.0), sky=(0.9, 0.9, 0.9))
    material((0.8, 0.8, 0.8, 1.0))
    for x, colour in ((-1.6, (1.0, 0.2, 0.2)), (1.6, (0.2, 1.0, 0.2))):
        light((-4.0 * x, 3.0, 5.0, 0.0), colour=colour)
        glPushMatrix()
        glTranslatef(x, 0.0, 0.0)
        ball(1.2)
        glPopMatrix()
    glViewport(0, 200, 100, 100)
    light((0.0, 3.0, 5.0, 0.0), colour=(0.2, 0.2, 1.0))
    ball(1.8)


def a_sun_without_light():
    """What is not lit has its own colour among what is."""
    look((0.0, 2.0, 7.0), sky=(0.0, 0.0, 0.0))
    glColor3f(1.0, 0.7, 0.1)
    ball(1.2)
    light((-4.0, 0.0, 3.0, 0.0))
    material((0.6, 0.6, 0.8, 1.0))
    glTranslatef(2.4, 0.0, 0.0)
    ball(0.8)


def coarse_balls():
    """Few facets: smooth, and flat."""
    look((0.0, 2.0, 7.0), sky=(0.9, 0.9, 0.9))
    light((4.0, 4.0, 3.0, 0.0))
    material((0.7, 0.7, 0.7, 1.0))
    for x, normals in ((-1.7, GLU_SMOOTH), (1.7, GLU_FLAT)):
        glPushMatrix()
        glTranslatef(x, 0.0, 0.0)
        glRotatef(60.0, 1.0, 0.2, 0.0)
        quadric = gluNewQuadric()
        gluQuadricNormals(quadric, normals)
        gluSphere(quadric, 1.5, 12, 8)
        gluDeleteQuadric(quadric)
        glPopMatrix()


def flat():
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glDisable(GL_DEPTH_TEST)


def menu():
    look((0.0, 2.0, 7.0))
    flat()
    glColor3f(0.7, 0.2, 0.2)
    glRectf(-0.5, -0.3, 0.5, 0.3)


def before_a_backdrop():
    look((0.0, 2.0, 7.0))
    glPushMatrix()
    flat()
    glBegin(GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glColor3f(0.1, 0.2, 0.4 + 0.3 * y)
        glVertex2f(x, y)
    glEnd()
    glEnable(GL_DEPTH_TEST)
    glMatrixMode(GL_PROJECTION)
    gluPerspective(50.0, WIDTH / HEIGHT, 0.1, 3000.0)
    glMatrixMode(GL_MODELVIEW)
    glPopMatrix()
    light((2.0, 5.0, 4.0, 0.0))
    box((0.0, 0.0, 0.0), 1.0)


def picture_behind(corners):
    """One textured quad over some of the window, flat and without depth; corners: x and y in
    -1..1."""
    glPushMatrix()
    flat()
    pixels = bytes((40, 140, 60) * 16)
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
    glEnable(GL_TEXTURE_2D)
    glColor3f(1.0, 1.0, 1.0)
    glBegin(GL_QUADS)
    for x, y in corners:
        glTexCoord2f(0.5 + 0.5 * x, 0.5 + 0.5 * y)
        glVertex2f(x, y)
    glEnd()
    glDisable(GL_TEXTURE_2D)
    glEnable(GL_DEPTH_TEST)
    glMatrixMode(GL_PROJECTION)
    gluPerspective(50.0, WIDTH / HEIGHT, 0.1, 3000.0)
    glMatrixMode(GL_MODELVIEW)
    glPopMatrix()


def on_a_picture():
    """A ball on a table that is a picture."""
    look((0.0, 2.0, 7.0), sky=(0.0, 0.0, 0.0))
    picture_behind(((-1, -1), (1, -1), (1, 1), (-1, 1)))
    light((2.0, 5.0, 4.0, 0.0))
    ball(1.0)


SCENES = {
    function.__name__: function
    for function in (
        floor_with_gls_normal, floor_with_its_own, chequers_of_material, chequers_of_colour,
        chequers_of_material_in_a_list, chequers_of_colour_in_a_list,
        chequers_in_a_list_that_says_how, road_without_depth_writes, road_without_depth_test,
        coloured_lamps, lamps_that_change, a_sun_without_light,
        coarse_balls, blended, menu, before_a_backdrop, glass_without_depth, glass_with_depth,
        in_fog, on_a_picture,
    )
}  # fmt: skip


def draw(scene):
    """A frame, with the state that a context begins with. scene: a function, or its name."""
    glPushAttrib(GL_ALL_ATTRIB_BITS)
    glEnable(GL_DEPTH_TEST)
    (SCENES[scene] if isinstance(scene, str) else scene)()
    glPopAttrib()


if __name__ == "__main__":
    pygame.display.init()
    pygame.display.set_mode((WIDTH, HEIGHT), pygame.OPENGL | pygame.DOUBLEBUF)
    for _ in range(100):
        draw(sys.argv[1])
        pygame.display.flip()

"""pygame's glcube with the fixed-function half of its own switch."""

from pygame.examples import glcube

glcube.USE_MODERN_GL = False
glcube.main()

"""Draws when there is an event, and says which keys it gets."""

import sys

import pygame
from pygame.event import wait

pygame.init()
pygame.display.set_mode((320, 240), pygame.OPENGL | pygame.DOUBLEBUF)

import toolkit_scene  # noqa: E402

running = True
while running:
    for event in [wait()] if "wait" in sys.argv else pygame.event.get():
        if event.type in (pygame.KEYDOWN, pygame.KEYUP):
            name = pygame.key.name(event.key)
            if event.type == pygame.KEYDOWN:
                print("key", name.upper() if len(name) > 1 else name, flush=True)
            elif name.startswith("f") and name != "f8":
                print("released", name, flush=True)
            running = event.key != pygame.K_ESCAPE
    toolkit_scene.angle = 20
    toolkit_scene.draw(320, 240)
    pygame.display.flip()
    pygame.time.wait(10)
pygame.quit()

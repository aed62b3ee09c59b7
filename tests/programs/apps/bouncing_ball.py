"""The ball of phalcopulse's own description, with a few more of its shapes."""

from phalcopulse import PhalcoPulseFX, PhalcoPulseStudio, pgfx


class BouncingBall(PhalcoPulseFX):
    def setup(self):
        self.position, self.velocity = 2.0, 0.5

    def loop(self, delta_time):
        self.velocity -= 0.98 * delta_time
        self.position += self.velocity * delta_time
        if self.position < 0.5:
            self.position, self.velocity = 0.5, -0.95 * self.velocity
        pgfx.draw_sphere(radius=0.5, color=(0.2, 0.6, 0.9), center=(0, self.position, 0))


PhalcoPulseStudio(scene_fx=BouncingBall(), width=800, height=600).run()

"""The solar system of Planet3D's own description."""

from Planet3D import Planet, generate_solar_system

earth = Planet(name="Earth", radius=0.6, orbit_radius=12.0, rotation_speed=0.9,
               color=(0.0, 0.5, 1.0))
mars = Planet(name="Mars", radius=0.4, orbit_radius=18.0, rotation_speed=0.8,
              color=(1.0, 0.0, 0.0))
saturn = Planet(name="Saturn", radius=1.5, orbit_radius=7.0, rotation_speed=0.5,
                color=(0.9, 0.8, 0.5))
earth.add_moon(name="Moon", radius=0.3, orbit_radius=3.0, rotation_speed=1.0,
               color=(0.8, 0.8, 0.8))
saturn.add_ring(radius=5.0, width=0.2, color=(0.8, 0.8, 0.8), transparency=0.3)
generate_solar_system([earth, mars, saturn])

"""liggghts_scene_time.py -- time step, end and output of a scene.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

from suna import Simulation, SunaError

from .scene_text import SceneText, text


class Times:
    """Of a SceneMaker (liggghts_scene.py)."""

    def add_time(self):
        step, place = min(s.step for s in self.stages), self.stages[-1].place
        limit, why = self.limit()
        self.scene.add("time", f"end {text(max(self.end, self.start + step))};", place)
        if step <= limit:
            self.scene.add("time", f"step {text(step)};")
        else:
            self.scene.add("time", f"step auto;  // the script has {text(step)}")
            self.report.approximated(place, "timestep", f"auto: {limit:.3g} s ({why}), as the "
                                     f"{step:.3g} s of the script are too long for this accuracy")
        interval = self.state["interval"]
        if interval and interval < self.end:
            self.scene.add("write", f"interval {text(interval)};")
        if self.state["wall_interval"]:
            self.scene.add("write", f"walls {text(100*step)};")

    def limit(self):
        """The longest step that the core takes, and why."""
        smallest = self.smallest()
        if not smallest:
            return math.inf, ""
        try:
            with Simulation(self.smallest_alone(smallest)) as sim:
                step, limit, why = sim.setup().step
        except SunaError as error:
            self.refuse(self.stages[-1].place, "run", f"the scene is refused: {error}")
        return limit, str(why)

    def smallest(self):
        """Smallest diameter of each material of particles."""
        found = {}

        def see(name, d):
            found[name] = min(found.get(name, math.inf), d)
        for i in self.insertions:
            for t in i.distribution.templates:
                see(self.material(t.type, t.density), 2*t.range()[0])
        p = self.particles
        for kind, density, d in zip(p.type, p.density, p.diameter):
            see(self.material(int(kind), float(density)), d)
        return found

    def smallest_alone(self, smallest):
        """A scene with one particle of each material, far apart, and a wall of each."""
        parts = SceneText()
        for name in ("materials", "effects", "pairs", "fluid"):
            parts.sections[name] = self.scene.sections[name]
        away = 10*max(smallest.values())
        for k, (name, d) in enumerate(smallest.items()):
            parts.add("insert", f"p{k} {{ type list; material {name}; "
                      f"positions (({text(away*k)} 0 {text(away)})); diameter {text(d)}; }}")
        for name in self.materials:
            parts.add("walls",
                      f"{name} {{ type plane; material {name}; point (0 0 0); normal (0 0 1); }}")
        return parts.text([])

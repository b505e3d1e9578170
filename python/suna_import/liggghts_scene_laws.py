"""liggghts_scene_laws.py -- materials, effects and pairs of a scene: the properties and contact
models of a script of LIGGGHTS.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from . import liggghts_heat
from .liggghts_contact import Need, laws
from .scene_text import braces, text, vector


class Laws:
    """Of a SceneMaker (liggghts_scene.py)."""

    def find_materials(self):
        for i in self.insertions:
            for t in i.distribution.templates:
                self.material(t.type, t.density, t.place)
        for kind, density in sorted(set(zip(self.particles.type, self.particles.density))):
            self.material(int(kind), float(density), self.particles.place)
        self.of_particles = list(self.materials)

    def material(self, kind, density=None, place=None, model=None):
        """Name of the material of a type; a wall takes one of its type, whatever its density."""
        for name, row in self.materials.items():
            if row[0] == kind and row[1] in (density, row[1] if density is None
                                             else None) and row[2] == model:
                return name
        if density is None:
            density = next((row[1] for row in self.materials.values()), 1000.0)
        first = name = f"type{kind}" + ("_wall" if model else "")
        number = 1
        while name in self.materials:
            number += 1
            name = f"{first}_{number}"
        self.materials[name] = (kind, density, model)
        return name

    def of_key(self, key):
        return self.material(*key)

    def add_contacts(self):
        self.add_materials()
        base, names = self.state["model"], list(self.materials)
        if not names:
            self.lacks(base.place, "pair_style", "there are neither particles nor walls at a run")
        main = self.of_particles[0] if self.of_particles else names[0]
        common = self.laws_of(main, main)
        if "rollingConstant" in common and any(t.shape for i in self.insertions for t in i.distribution.templates):
            self.refuse(base.place, "rolling_friction cdt", "it is wrong for clumps, whose form resists rolling; "
                        "leave it out, or take epsd or epsd2")
        if self.state["gravity"] is not None:
            g, place = self.state["gravity"]
            self.scene.add("effects", f"gravity {{ acceleration {vector(g)}; }}", place)
        for effect, settings in common.items():
            self.scene.add("effects", braces(effect, settings), self.source(effect, base))
        if self.state["heat"] is not None:
            settings = liggghts_heat.effect(self.state["heat"], base, self.report)
            self.scene.add("effects", braces("conduction", settings), self.state["heat"].place)
        for k, a in enumerate(names):
            for b in names[k:]:
                if a in self.of_particles or b in self.of_particles:
                    self.add_pair(a, b, common)

    def add_materials(self):
        properties = self.state["properties"]
        for name, (kind, density, _) in self.materials.items():
            try:
                e, nu = (self.need(properties, word, kind)
                         for word in ("youngsModulus", "poissonsRatio"))
                thermal = "" if self.state["heat"] is None else liggghts_heat.of_material(
                    self.state["heat"], properties, kind, self.need)
            except Need as need:
                self.refuse(self.state["model"].place, f"property/global {need}", need.why)
            self.scene.add("materials",
                           f"{name} {{ density {text(density)}; youngsModulus {text(e)}; "
                           f"poissonsRatio {text(min(nu, 0.49999))};{thermal} }}",
                           properties.places["youngsModulus"])

    def add_pair(self, a, b, common):
        """Settings of a pair of materials that differ from the effects' settings."""
        differ = {e: {k: v for k, v in values.items() if common[e].get(k) != v}
                  for e, values in self.laws_of(a, b).items()}
        differ = {e: values for e, values in differ.items() if values}
        if differ:
            model = self.materials[b][2] or self.materials[a][2] or self.state["model"]
            self.scene.named("pairs", f"{a}_{b}", f"between ({a} {b}); " + " ".join(
                braces(e, v) for e, v in differ.items()), model.place)

    def need(self, properties, name, kind):
        if not properties.has(name):
            raise Need(name)
        return properties.value(name, kind)

    def laws_of(self, a, b):
        base = self.state["model"]
        model = self.materials[a][2] or self.materials[b][2] or base
        try:
            return laws(model, base, self.state["properties"], self.materials[a][0],
                        self.materials[b][0])
        except Need as need:
            self.refuse(model.place, f"property/global {need}", need.why)

    def source(self, effect, base):
        word = {"dry": "coefficientRestitution", "mindlin": "coefficientFriction",
                "linear": "coefficientFriction", "mindlinIncremental": "coefficientFriction",
                "sjkr": "cohesionEnergyDensity", "rollingConstant": "coefficientRollingFriction",
                "rollingSpring": "coefficientRollingFriction"}.get(effect)
        return self.state["properties"].places.get(word, base.place)

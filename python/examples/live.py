import suna

sim = suna.Simulation("""
materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.25; } }
effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.3; } mindlin { friction 0.4; } }
domain { x (0 0.01); y (0 0.01); periodic (x y); }
walls { floor { type plane; point (0 0 0); normal (0 0 1); } lid { type plane; point (0 0 0.03); normal (0 0 -1); } }
insert { grains { type random; count 900; diameter 1e-3; min (0 0 0); max (0.01 0.01 0.03); seed 1; } }
""")
sim.advance(0.2)
ids = sim.add(position=[[0.005, 0.005, 0.025]], diameter=1e-3, material="glass", velocity=(0, 0, -1))
sim.advance(0.05)
sim.set(ids, velocity=(0, 0, 1))
sim.wall("lid").motion = {"type": "translation", "velocity": (0, 0, -0.1), "start": sim.time}
sim.advance(1, until=lambda s: s.wall("lid").force[2] > 0.5, every=100)
sim.change({"effects/mindlin/friction": 0.1})
sim.remove(ids)


@sim.add_force
def shake(p):
    p.force += p.mass[:, None]*(2*(p.time % 0.01 < 0.005) - 1, 0, 0)


sim.advance(0.02)
print(sim.to_dataframe().describe())

import suna

sim = suna.Simulation("""
materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.25; } }
effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.7; } mindlin { friction 0.4; } }
walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); } }
insert { grains { type random; count 300; diameter 1e-3; min (-0.004 -0.004 0); max (0.004 0.004 0.02); seed 1; } }
""", energy=True)
sim.advance(0.1)
print(sim)
print("centre of mass", sim.mass @ sim.position/sim.mass.sum())
print("energy", sim.energy)

#!/usr/bin/env python3
"""compare.py -- runs of one bed in DPMFoam and Suna: motion of the bed, error against finer steps,
cost.

    compare.py WINDOW [-store "text"]    reads runs/WINDOW.CODE.STEPS.DELTAT, writes
                                         runs/result.WINDOW.csv and runs/WINDOW.png;
                                         with -store also stored/, and the table of results.md if it has one
    compare.py WINDOW -draw              stored/WINDOW.png from stored/result.WINDOW.csv

CODE is dpm or suna, STEPS the steps in a contact, DELTAT the time step of the gas. The reference of
each code is its run with most steps.

height       of the center of mass, less its value at the first output [m]; error over its change
kinetic      energy of the particles' motion [J]
fluctuation  the same about the mean velocity in boxes of 15 mm [J]: collisions decide it
pressure     drop over the bed, mean since the previous output, without the weight of the gas [Pa];
             its error leaves out the first output, in which the gas is set in motion
error        rms over the outputs, over the rms of the reference
processor    OpenFOAM's ExecutionTime [s] from the end of the first gas step on, plus the same for
             that step; with output, without set-up

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import numpy
from dem_case import OURS, REFERENCE, below, panels, plain_ticks, save
from lagrangian import DENSITY, DIAMETER, read_state

# of the gas, kg/m3; its pressure on the plate over rho in DPMFoam, m2/s2
RHO, OWN_WEIGHT = 1.2, 9.81*0.45
MASS = DENSITY*numpy.pi/6*DIAMETER**3
BOX = 0.015
NAMES = {"dpm": "DPMFoam", "suna": "Suna"}
LABELS = {"kinetic": "kinetic energy", "fluctuation": "energy of the\nfluctuation", "pressure": "pressure drop"}
QUANTITIES = {"height": "m", "kinetic": "J", "fluctuation": "J", "pressure": "Pa"}


class Run:
    """code, steps, delta, processor; time and a row a quantity, at the outputs."""

    def __init__(self, folder):
        self.code, steps, delta = folder.name.split(".", 3)[1:]
        self.steps, self.delta = int(steps), float(delta)
        outputs = sorted((float(f.name), f) for f in folder.iterdir()
                         if re.fullmatch(r"[0-9.e-]+", f.name) and float(f.name) > 0)
        self.time = numpy.array([time for time, _ in outputs])
        states = [read_state(place) for _, place in outputs]
        height = numpy.array([x[:, 2].mean() for x, _ in states])
        self.rows = {"height": height, "kinetic": numpy.array([energy(v) for _, v in states]),
                     "fluctuation": numpy.array([fluctuation(x, v) for x, v in states]),
                     "pressure": self.pressure(folder)}
        self.folder = folder

    def log(self, end):
        """Processor time and steps of the particles up to this time."""
        word = r"(\d+) move-collide subCycles" if self.code == "dpm" else r"(\d+) DEM steps, void"
        text = (self.folder/("log.DPMFoam" if self.code == "dpm"
                             else "log.demPimpleFoam")).read_text()
        spent, steps = [], 0
        for part in re.split(r"^Time = ", text, flags=re.M)[1:]:
            clock = re.search(r"^ExecutionTime = (\S+) s", part, re.M)
            if float(part.split()[0]) > end + 1e-9 or not clock:
                break
            spent.append(float(clock[1]))
            steps += sum(map(int, re.findall(word, part)))
        return (spent[-1] - spent[0])*len(spent)/(len(spent) - 1), steps

    def pressure(self, folder):
        t, p = numpy.loadtxt(folder/"postProcessing/plate/0/surfaceFieldValue.dat").T
        p = RHO*(p - (OWN_WEIGHT if self.code == "dpm" else 0.0))
        later = p[(t > self.time[0] + 1e-9) & (t < self.time[-1] + 1e-9)]
        self.jump = numpy.sqrt((numpy.diff(later)**2).mean())
        edges = numpy.concatenate([[0.0], self.time])
        return numpy.array([p[(t > a + 1e-9) & (t < b + 1e-9)].mean()
                            for a, b in zip(edges, edges[1:])])

    def cut(self, end):
        keep = self.time < end + 1e-9
        self.time, self.rows = self.time[keep], {name: row[keep] for name, row in self.rows.items()}
        self.processor, self.particle_steps = self.log(end)

    def errors(self, fine):
        found = {}
        for name, row in self.rows.items():
            first = 1 if name == "pressure" else 0
            off, scale = (row - fine.rows[name])[first:], (fine.rows[name] -
                (fine.rows[name][0] if name == "height" else 0.0))[first:]
            found[name] = numpy.sqrt((off**2).mean()/(scale**2).mean())
        return found

    def __str__(self):
        return f"{NAMES[self.code]}, {self.steps} steps, gas {self.delta:g} s"


def energy(v):
    return 0.5*MASS*(v*v).sum()


def fluctuation(x, v):
    """About the mean of each box of the column."""
    box = numpy.floor((x + [0.0075, 0.075, 0.0])/BOX).astype(int)
    _, box = numpy.unique(box, axis=0, return_inverse=True)
    box = box.ravel()
    number = numpy.bincount(box)
    mean = numpy.stack([numpy.bincount(box, v[:, a])/number for a in range(3)], axis=1)
    return energy(v - mean[box])


def read_runs(window):
    runs = [Run(folder) for folder in sorted(Path("runs").glob(f"{window}.*")) if folder.is_dir()]
    end = min(run.time[-1] for run in runs)
    for run in runs:
        run.cut(end)                                        # the others' last output
        if len(run.time) != len(runs[0].time) or abs(run.time - runs[0].time).max() > 1e-9:
            sys.exit(f"{run} has outputs at {run.time} s, {runs[0]} at {runs[0].time} s")
    return sorted(runs, key=lambda run: (run.code, -run.steps, run.delta))


def finest(runs, code):
    return max((run for run in runs if run.code == code), key=lambda run: (run.steps, -run.delta))


def summarize(runs):
    """Rows of the table: run, processor time, per simulated second, the quantities at the end,
    errors."""
    rows = []
    for run in runs:
        fine = finest(runs, run.code)
        errors = run.errors(fine) if run is not fine else dict.fromkeys(QUANTITIES, None)
        rows.append((NAMES[run.code], run.steps, run.delta, run.processor,
                     run.processor/run.time[-1],
                     *(row[-1] for row in run.rows.values()), *errors.values()))
    return rows


def cheapest(runs, wanted):
    """The cheapest run of Suna with every error at most the wanted one."""
    fine = finest(runs, "suna")
    fit = [run for run in runs if run.code == "suna" and run is not fine
           and all(value <= wanted[name] for name, value in run.errors(fine).items())]
    return min(fit, key=lambda run: run.processor, default=None)


def verdicts(runs):
    """Sentences: runs of DPMFoam against the cheapest ones of Suna whose four errors are no larger."""
    fine = finest(runs, "dpm")
    for run in runs:
        if run.code == "dpm" and run is not fine and run.steps >= 12:       # the stock case has 12
            ours = cheapest(runs, run.errors(fine))
            yield (f"{run}: {run.processor:.4g} s; as accurate: " +
                   (f"{ours}, {ours.processor:.3g} s, 1/{run.processor/ours.processor:.3g} of the time" if ours else "no run of ours"))
    theirs, ours = finest(runs, "dpm"), finest(runs, "suna")
    off = ours.errors(theirs)
    yield "both at their finest, what Suna differs by: " + ", ".join(f"{name} {100*value:.2g} %"
        for name, value in off.items())
    yield f"change of the pressure from one gas step to the next, rms: DPMFoam {theirs.jump:.3g} Pa, Suna {ours.jump:.3g} Pa"


def draw(rows, path):
    """From the table: errors over processor time, and where the two codes end."""
    if sum(row[-1] not in (None, "") for row in rows) > 2:
        figure, (errors, ends) = panels(2, 10, 3.6, width_ratios=(1.3, 1))
        draw_errors(errors, rows)
        below(figure, errors, columns=4)
    else:
        figure, (ends,) = panels(1, 6, 2.2)
    draw_ends(ends, rows)
    save(figure, path)


def draw_errors(errors, rows):
    for code, colour, mark in (("DPMFoam", REFERENCE, "o"), ("Suna", OURS, "s")):
        for delta, filled in ((2e-5, True), (1e-4, False)):
            own = [row for row in rows if row[0] == code and row[2] == delta and row[-1] not in (None, "")]
            if not own:
                continue
            worst = [100*max(map(float, row[-len(QUANTITIES):])) for row in own]
            errors.loglog([float(row[3]) for row in own], worst, mark, ms=6, color=colour,
                          mfc=colour if filled else "none", label=f"{code}, gas step {1e6*delta:g} µs")
            before = None
            for row, error in zip(own, worst):
                time = float(row[3])
                left = before is not None and 0.9 < time/before < 1        # beside the number of the point before
                errors.annotate(row[1], (time, error), (-1 if left else 3, 4), textcoords="offset points", fontsize=8,
                                rotation=45, ha="right" if left else "left")
                before = time
    errors.set(xlabel="processor time [s]", ylabel="largest error of four quantities [%]",
               title="error against the code's finest run (numbers: steps in a contact)")
    plain_ticks(errors.xaxis, (1, 2, 5, 10, 20, 50, 100))
    errors.set_xlim(1, 100)


def draw_ends(ends, rows):
    fine = {code: next(row for row in rows if row[0] == code) for code in ("DPMFoam", "Suna")}
    names = list(QUANTITIES)[1:]
    ratio = [float(fine["Suna"][6 + k])/float(fine["DPMFoam"][6 + k]) for k in range(len(names))]
    ends.barh([LABELS[name] for name in names], ratio, color=OURS, height=0.5)
    for k, value in enumerate(ratio):
        inside = value > 0.3
        ends.annotate(f"{value:.2f}", (0 if inside else value, k), (6, 0), textcoords="offset points", va="center",
                      color="white" if inside else "black")
    ends.axvline(1, color=REFERENCE, lw=1.2)
    ends.set(xlabel="Suna over DPMFoam (1), finest runs, at the end", xlim=(0, 1.4))


def number(value):
    return "" if value is None else f"{value:.6g}" if isinstance(value, float) else str(value)


def table(rows):
    """The runs with their errors; values and times per simulated second are in the CSV."""
    lines = ["| | steps in a contact | gas step, s | processor, s | errors in %: height | kinetic | fluctuation | pressure |",
             "|" + "---|"*8]
    for code, steps, delta, processor, _, *values in rows:
        errors = ["" if e is None else f"{100*e:.2g}" for e in values[len(QUANTITIES):]]
        lines.append("| " + " | ".join([code, str(steps), f"{delta:g}", f"{float(f'{processor:.3g}'):g}", *errors]) + " |")
    return "\n".join(lines)


def store(text, window, rows, sentences):
    Path("stored").mkdir(exist_ok=True)
    for file in (f"result.{window}.csv", f"{window}.png"):
        Path("stored", file).write_bytes(Path("runs", file).read_bytes())
    page = Path("results.md")
    before, found, rest = page.read_text().partition(f"<!-- {window} -->\n")
    if not found:
        print(f"results.md has no <!-- {window} -->: the table is not stored there")
        return
    after = rest.partition("<!-- end -->")[2]
    listing = "\n".join(f"- {sentence}" for sentence in sentences)
    page.write_text(f"{before}{found}{text}:\n\n{table(rows)}\n\n{listing}\n<!-- end -->{after}")


def main():
    window = sys.argv[1]
    if sys.argv[2:3] == ["-draw"]:
        with open(f"stored/result.{window}.csv", newline="") as file:
            rows = [[row[0], int(row[1]), float(row[2]), *row[3:]] for row in list(csv.reader(file))[1:]]
        draw(rows, f"stored/{window}.png")
        return
    runs = read_runs(window)
    rows, sentences = summarize(runs), list(verdicts(runs))
    with open(f"runs/result.{window}.csv", "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["code", "steps", "deltaT", "processor", "perSecond", *QUANTITIES,
                      *(f"error_{name}" for name in QUANTITIES)])
        out.writerows([number(x) for x in row] for row in rows)
    for run in runs:
        print(f"{str(run):36s} {run.processor:8.2f} s  at {run.time[-1]:g} s: " +
              "  ".join(f"{n} {row[-1]:.6g} {QUANTITIES[n]}" for n, row in run.rows.items())
              + f"  {run.particle_steps} steps of the particles")
    print(table(rows), *sentences, sep="\n")
    draw(rows, f"runs/{window}.png")
    if sys.argv[2:3] == ["-store"]:
        store(sys.argv[3], window, rows, sentences)


if __name__ == "__main__":
    main()

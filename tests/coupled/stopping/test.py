"""Signals, a file `stop`, progress and edits during a coupled run.

- SIGTERM, SIGUSR1 and SIGINT, and a file `stop` in the case, end demPimpleFoam, and pimpleFoam with the function
  object, after the present step with fluid and particles written; the run continues with the bits of one that was not
  stopped.
- A second SIGTERM ends a run within a fluid step of a minute.
- A second run in the case of a run is refused.
- A file `stop` from before the run is removed and does not end it.
- The log shows progress with long and with short steps.
- Edits of constant/demProperties are reported with the entries that differ.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *


def said(case, log, pattern):
    """Wait up to a minute for such a line."""
    return until(lambda: re.search(pattern, case.read(log), re.M))


# ---- does mpirun pass signals on? ------------------------------------------------------------------


def passes_on():
    case = Case("waits", "restart")
    case.write("waits", """
trap 'echo caught; exit 0' USR1
echo ready
for ((k = 0; k < 300; k++)); do sleep 0.1; done
""")
    process = case.start("mpirun", "-np", "2", "bash", "waits")
    if said(case, "log.mpirun", "ready"):
        process.send_signal(signal.SIGUSR1)
    case.ended(process, 40)
    return "caught" in case.log("mpirun")


# Debian's pocl makes mpirun keep SIGUSR1 for itself, unless HWLOC_COMPONENTS=-opencl is set. Where mpirun keeps it all the
# same, the ranks get it
passed_on = passes_on()
if passed_on or "-opencl" not in os.environ.get("HWLOC_COMPONENTS", ""):
    claim("mpirun passes SIGUSR1 on (else export HWLOC_COMPONENTS=-opencl)", passed_on)
else:
    skip("mpirun passes SIGUSR1 on", "it does not here, with HWLOC_COMPONENTS=-opencl")

# ---- signals ---------------------------------------------------------------------------------------


def refused(case, solver, process):
    """A second run in the case is refused, with the process of the first."""
    second = case.run(solver, log="log.second", limit=60)
    return second.status not in (0, 124) and re.search(
        f"another run writes into the folder .*: process {process.pid} on host {os.uname().nodename}", second.log)


def send(process, ranks, sent):
    """Send a signal to a run: to mpirun, which passes it on, or to its ranks."""
    if ranks == 1 or passed_on:
        process.send_signal(sent)
        return
    for children in Path(f"/proc/{process.pid}/task").glob("*/children"):
        for rank in children.read_text().split():
            os.kill(int(rank), sent)


def stopped(solver, ranks, sent):
    """A run is stopped by a signal, or by the file `stop`, and continued."""
    name = sent.name if sent else "the file stop"
    what = f"{solver} on {ranks} rank(s), {name}"
    case = Case(f"{solver}.{ranks}", "restart")
    case.append("system/controlDict", function_object*(solver == "pimpleFoam"))
    case.edit("system/controlDict", endTime=1000, writeInterval=500)
    folder = "."
    if ranks > 1:
        folder = "processor0"
        case.run("decomposePar")
    (case/"stop").touch()
    # with the handling of signals of a terminal
    command = [solver] if ranks > 1 else ["env", "--default-signal=INT,TERM,USR1", solver]
    process = case.start(*command, ranks=ranks, log=f"log.{solver}")
    said(case, f"log.{solver}", "Time = 0.003")
    if ranks == 1:
        claim(f"{what}: a second run in the case is refused, with the process of the first",
              refused(case, solver, process))
    if sent:
        send(process, ranks, sent)
    else:
        (case/"stop").touch()
    claim(f"{what}: the run ends properly", case.ended(process) == 0)
    claim_ran(f"{what}: with End", case, solver)
    claim(f"{what}: the lock of the case is gone", not (case/"lock").exists())
    claim(f"{what}: it says where to continue",
          case.found(f"^Suna: stopped by {name} after time .* latestTime .* continues", solver))
    claim(f"{what}: an old file stop is removed, and the log says so",
          not (case/"stop").exists() and case.found("^Suna: the file stop, which was there before", solver))
    written = [path.parts[-3] for path in case.path.glob(f"{folder}/[0-9]*/uniform/dem.snapshot")]
    claim(f"{what}: one time is written, fluid and particles, the last one",
          written == [case.found("^Time = (.*)", solver)[1]] and (case/folder/written[0]/"U").stat().st_size)

    end = f"{float(written[0]) + 0.004:g}"
    case.edit("system/controlDict", endTime=end, writeInterval=0.001, startFrom="latestTime")
    claim_runs(f"{what}: it continues with startFrom latestTime", case, solver, ranks=ranks)
    (case/folder/end).rename(case/"continued")
    case.remove("0.[0-9]*", "processor*/0.[0-9]*")
    case.run(solver, ranks=ranks)
    claim(f"{what}: with the bits of a run that was not stopped",
          all(agrees(case/"continued"/field, case/folder/end/field) for field in ("U", "phi", "p")) and
          snapshot_hash(case/"continued/uniform/dem.snapshot") == snapshot_hash(case/folder/end/"uniform/dem.snapshot"))


stopped("demPimpleFoam", 1, signal.SIGTERM)
stopped("pimpleFoam", 1, signal.SIGINT)
stopped("pimpleFoam", 2, signal.SIGUSR1)
stopped("demPimpleFoam", 2, None)
if thorough:
    stopped("demPimpleFoam", 2, signal.SIGUSR1)
    stopped("pimpleFoam", 1, None)

# ---- progress --------------------------------------------------------------------------------------

# short steps
short = Case("short", "restart")
short.append("system/controlDict", function_object)
short.edit("system/controlDict", endTime=1000, writeInterval=500, runTimeModifiable="yes")
run_short = short.start("pimpleFoam")

# steps of a minute
long = Case("long", "restart")
long.edit("system/controlDict", endTime=0.01)
long.sub("constant/demProperties", "youngsModulus 1e6", "youngsModulus 1e15")
run_long = long.start("demPimpleFoam")


def consistent(case, log, most):
    """In the first line of progress the time left follows from the share done after 10 s, within a factor of 3 (the
    line is written after the next step, of a machine that may be busy), and at most this number of fluid steps is
    done."""
    line = said(case, log, "^Suna: progress (.*) %, (.*) s left, (.*) fluid steps/s, (.*) particle-steps/s")
    percent, left, steps, particle_steps = map(float, line.groups())
    expected = 10*(100 - percent)/percent
    return expected/3 < left < 3*expected and 10*steps <= most and particle_steps > 0


claim("progress: within a fluid step of a minute", lambda: consistent(long, "log.demPimpleFoam", 1))
claim("... and the list before the first step warns of it",
      long.found(r"^ +[0-9]+\. a fluid step of 0.001 s is [0-9]+ DEM steps"))
# more than twice: one of them may arrive within two seconds of the first
for k in range(60):
    if run_long.poll() is not None:
        break
    run_long.terminate()
    time.sleep(1)
claim("a second SIGTERM ends a run within a fluid step of a minute", long.ended(run_long) == 1 and long.found(
    "stopped within a fluid step by a second signal, SIGTERM; its last good state is the one that it started from"),
    *long.log().splitlines()[-12:])
claim("progress: of short steps", said(short, "log.pimpleFoam", "^Suna: progress .* fluid steps/s"))

# ---- edits -----------------------------------------------------------------------------------------

properties = "constant/demProperties"
before = short.read(properties)
after = re.sub("^averages.*", "", before.replace("restitution 0.7", "restitution 0.6"), 0, re.M)
short.write(properties, after + "outlets { top { point (0 0 0.1); normal (0 0 1); } }\n")
claim("edits: the entries that differ are reported",
      said(short, "log.pimpleFoam", "demProperties has changed during the run: removed averages, "
           "changed effects/dry/restitution, added outlets; the run goes on without that"))
short.write(properties, before)
claim("edits: and that they are taken back",
      said(short, "log.pimpleFoam", "demProperties is again what the run has read"))
short.write(properties, before + "outlets { top { point\n")
claim("edits: a file that is half written is reported",
      said(short, "log.pimpleFoam", "demProperties has changed during the run and cannot be read"))
short.write(properties, before)
run_short.terminate()
claim("edits: the run continues until it is stopped", short.ended(run_short) == 0)
finish()

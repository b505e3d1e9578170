"""view_in_paraview.py -- opens a run in ParaView: particles as spheres coloured by speed, walls, the void
fraction on a slice through the middle of the mesh, the time.

    paraview --script=.../view_in_paraview.py                   in the folder of a run
    pvpython .../view_in_paraview.py [FOLDER] [PICTURE.png]     the last time as a picture, without a window

FOLDER is one that `dem run` has written, with particles.pvd, or an OpenFOAM case, reconstructed or in
processor folders; without it, the environment variable SUNA_RUN or the present folder. In ParaView's
window it works as a macro, too (Macros, Import new macro). Needs ParaView 5.10 or later.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys
from pathlib import Path

from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

# colours from the lower to the upper end of a scale: yellow to brown, and grey
SPEED = [(0.98, 0.93, 0.70), (0.99, 0.60, 0.16), (0.40, 0.14, 0.02)]
VOID = [(0.15, 0.15, 0.18), (0.95, 0.95, 0.95)]
SIZE = (1400, 900)          # of a picture [pixel]


class Stop(Exception):
    """why there is nothing to show"""


def open_run(folder):
    """What a folder has: particles with the names of velocity and diameter, walls, mesh; None for what lacks."""
    if (folder/"particles.pvd").exists():
        walls = folder/"walls.pvd"
        return (simple.PVDReader(FileName=str(folder/"particles.pvd")), "velocity", "diameter",
                simple.PVDReader(FileName=str(walls)) if walls.exists() else None, None)
    if not (folder/"system"/"controlDict").exists():
        raise Stop(f"{folder} has neither particles.pvd nor system/controlDict; give the folder of a run")
    # the reader wants a file of any content and name beside system/
    file = folder/(folder.resolve().name + ".foam")
    file.touch()
    times = [name for name in os.listdir(folder) if name.replace(".", "").replace("e-", "").isdigit() and name != "0"]
    case = simple.OpenFOAMReader(FileName=str(file))
    case.CaseType = "Reconstructed Case" if times or not (folder/"processor0").exists() else "Decomposed Case"
    case.UpdatePipelineInformation()
    clouds = [name for name in case.MeshRegions.Available if name.startswith("lagrangian/")]
    if not clouds:
        raise Stop(f"{folder} has no particles in its time folders; run it first")
    case.MeshRegions = ["internalMesh", clouds[0]]
    case.CellArrays = [name for name in ("voidFraction", "U", "p") if name in case.CellArrays.Available]
    case.UpdatePipeline(max(case.TimestepValues))
    cloud = simple.MergeBlocks(simple.ExtractBlock(Input=case, Selectors=["//" + clouds[0].split("/")[-1]]))
    mesh = simple.MergeBlocks(simple.ExtractBlock(Input=case, Selectors=["//internalMesh"]))
    return cloud, "U", "d", None, mesh


def times_of(source):
    """All times [s] of the reader that a source comes from."""
    while not getattr(source, "TimestepValues", None) and hasattr(source, "Input"):
        source = source.Input
    values = source.TimestepValues
    return list(values) if hasattr(values, "__len__") else [values]


def bounds(source):
    source.UpdatePipeline()
    box = source.GetDataInformation().GetBounds()
    return [(box[2*k], box[2*k + 1]) for k in range(3)]


def colour(display, view, association, name, component, colours, title, span):
    """Colour what is shown by an array, with a legend."""
    simple.ColorBy(display, (association, name, component) if component else (association, name))
    table = simple.GetColorTransferFunction(name)
    low, high = span
    table.ColorSpace = "Lab"
    table.RGBPoints = [number for k, own in enumerate(colours)
                       for number in (low + (high - low)*k/(len(colours) - 1), *own)]
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = (0, 0, 0)
    bar.TitleFontSize = bar.LabelFontSize = 14
    display.SetScalarBarVisibility(view, True)


def show_particles(source, view, velocity, diameter):
    """Spheres of the particles' diameter; a tenth of a per cent of the fastest are above the colours."""
    display = simple.Show(source, view)
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset = "Sphere"
    display.ScaleByArray, display.UseScaleFunction = 1, 0
    display.SetScaleArray = ["POINTS", diameter]
    display.GaussianRadius = 0.5
    top, times = 0.0, times_of(source)
    for time in times[::max(1, len(times)//10)]:        # ten times tell the range
        source.UpdatePipeline(time)
        points = servermanager.Fetch(source).GetPointData().GetArray(velocity)
        if points and points.GetNumberOfTuples():
            speed = (vtk_to_numpy(points).astype(float)**2).sum(axis=1)**0.5
            speed.sort()
            top = max(top, speed[int(0.999*(len(speed) - 1))])
    colour(display, view, "POINTS", velocity, "Magnitude", SPEED, "speed [m/s]", (0.0, float(top) or 1.0))


def show_mesh(mesh, view, axis):
    """The void fraction on the plane in the middle, normal to the thinnest direction."""
    low, high = zip(*bounds(mesh))
    cut = simple.Slice(Input=mesh)
    cut.SliceType.Origin = [0.5*(a + b) for a, b in zip(low, high)]
    cut.SliceType.Normal = [float(k == axis) for k in range(3)]
    display = simple.Show(cut, view)
    if "voidFraction" in cut.CellData.keys():
        display.Ambient, display.Diffuse = 1, 0
        colour(display, view, "CELLS", "voidFraction", None, VOID, "void fraction", (0.35, 1.0))
    frame = simple.Show(mesh, view)
    frame.SetRepresentationType("Outline")
    frame.AmbientColor = frame.DiffuseColor = (0.4, 0.4, 0.4)


def new_view():
    view = simple.CreateRenderView()
    view.UseColorPaletteForBackground = 0
    view.Background = (1, 1, 1)
    view.OrientationAxesVisibility = 1
    view.OrientationAxesLabelColor = (0, 0, 0)
    view.CameraParallelProjection = 1
    return view


def front(box):
    """The direction in which the box is thinnest; y if it is nearly so."""
    size = [high - low for low, high in box]
    return 1 if size[1] < 1.1*min(size) else size.index(min(size))


def look(view, box, axis):
    """From the front, with z up unless it is the thinnest direction."""
    middle = [0.5*(a + b) for a, b in box]
    far = max(b - a for a, b in box) or 1.0
    view.CameraFocalPoint = middle
    view.CameraPosition = [m + (far*(-3 if axis == 1 else 3) if k == axis else 0) for k, m in enumerate(middle)]
    view.CameraViewUp = (0, 1, 0) if axis == 2 else (0, 0, 1)
    view.ResetCamera()


def show(folder, size=None):
    """All views of a run, in a row; of this size [pixel] together, or as large as the window."""
    particles, velocity, diameter, walls, mesh = open_run(folder)
    scene, last = simple.GetAnimationScene(), max(times_of(particles))
    scene.UpdateAnimationUsingDataTimeSteps()
    particles.UpdatePipeline(last)
    box = bounds(mesh or walls or particles)
    axis = front(box)
    layout = simple.CreateLayout("Suna")
    views = [new_view()]
    simple.AssignViewToLayout(views[0], layout)
    show_particles(particles, views[0], velocity, diameter)
    if walls:
        display = simple.Show(walls, views[0])
        display.SetRepresentationType("Surface")
        display.Opacity = 0.15
        simple.ColorBy(display, None)
    if mesh:
        frame = simple.Show(mesh, views[0])
        frame.SetRepresentationType("Outline")
        frame.AmbientColor = frame.DiffuseColor = (0.4, 0.4, 0.4)
        layout.SplitHorizontal(0, 0.5)
        views.append(new_view())
        simple.AssignViewToLayout(views[1], layout, 2)
        show_mesh(mesh, views[1], axis)
    clock = simple.AnnotateTimeFilter(particles)
    clock.Format = "{time:.4g} s" if hasattr(clock, "Format") and "{" in clock.Format else "%.4g s"
    label = simple.Show(clock, views[0])
    label.Color, label.FontSize = (0, 0, 0), 16
    scene.AnimationTime = last
    if size:                    # before the cameras: they fit the box into the view
        layout.SetSize(*size)
    for view in views:
        view.ViewTime = last
        look(view, box, axis)
        simple.Render(view)
    return layout


def main():
    words = [word for word in sys.argv[1:] if not word.startswith("-")]
    picture = next((word for word in words if word.endswith(".png")), None)
    folders = [word for word in words if word != picture]
    folder = Path(folders[0] if folders else os.environ.get("SUNA_RUN") or os.getcwd())
    layout = show(folder, SIZE if picture else None)
    if picture:
        simple.SaveScreenshot(picture, layout, ImageResolution=SIZE)
        print(picture)


try:
    main()
except Stop as reason:
    print(f"view_in_paraview: {reason}", file=sys.stderr)
    if sys.argv[1:]:            # not in ParaView's window, which would end
        sys.exit(1)

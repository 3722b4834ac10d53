"""Designs a function on a mesh from peaks, pits and passes, and draws its level sets and its Morse complex.

usage: pvpython design_function.py PLUGIN MESH PICTURE.png [--peak X Y Z]... [--pit X Y Z]... [--pass X Y Z]... [--clean]
                                   [--approach MeshBased|Meshless] [--state FILE.pvsm] [--contours N] [--view X Y Z]
                                   [--up X Y Z]

PLUGIN is SurfaceScalars.so; MESH is anything that ParaView opens as triangles or quads. If no point is given, there are those
of Data/elephant.vtk: peaks at the tip of the trunk and the rump, a pass on the back between them, pits under the feet. Left:
the function, its level sets and its critical points: minima blue, saddles green, maxima red; small ones were not asked for.
Right: the Morse complex, lines of steepest descent from the saddles in blue, of steepest ascent in red.

A state written with --state opens in the ParaView window (File > Load State, after Tools > Manage Plugins > Load New). Each
point is a Point Source: select "peak 1" in the Pipeline Browser, drag its handle along the surface, and the function
follows, at once with Apply Changes Automatically (the button with the gear).
"""

import argparse
import time

import numpy
from paraview.simple import *
from vtk.util.numpy_support import vtk_to_numpy

KINDS = {"peak": 3, "pit": 0, "pass": 1}
ELEPHANT = {
    "peak": [[0.184, 0.500, 0.089], [-0.162, -0.021, 0.056]],
    "pit": [[-0.132, -0.500, -0.030], [0.099, -0.475, -0.035], [0.297, -0.340, -0.226], [-0.340, -0.436, -0.180]],
    "pass": [[-0.050, -0.047, -0.006]],
}

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("plugin")
parser.add_argument("mesh")
parser.add_argument("picture")
for kind in KINDS:
    parser.add_argument(f"--{kind}", nargs=3, type=float, action="append", default=[], metavar=("X", "Y", "Z"))
parser.add_argument("--clean", action="store_true", help="remove what is not required")
parser.add_argument("--approach", default="MeshBased")
parser.add_argument("--state")
parser.add_argument("--contours", type=int, default=30)
parser.add_argument("--view", nargs=3, type=float, default=[0, 0.2, 1], help="from where to look")
parser.add_argument("--up", nargs=3, type=float, default=[0, 1, 0])
options = parser.parse_args()
LoadPlugin(options.plugin, remote=False, ns=globals())  # from now on its filters are functions

mesh = OpenDataFile(options.mesh)
mesh.UpdatePipeline()
places = {kind: getattr(options, kind) for kind in KINDS}
if not any(places.values()):
    places = ELEPHANT
handles, typed = [], []
for kind, code in KINDS.items():
    for number, place in enumerate(places[kind], 1):
        handles.append(PointSource(registrationName=f"{kind} {number}", Center=place, Radius=0))
        typed.append(Calculator(
            registrationName=f"type of {kind} {number}", Input=handles[-1], ResultArrayName="CriticalType", Function=str(code)))
points = GroupDatasets(registrationName="critical points", Input=typed)
design = ScalarFunctionDesign(
    registrationName="function", Input=mesh, CriticalPoints=points, CleanUp=options.clean, Approach=options.approach)


def update():
    start = time.perf_counter()
    design.UpdatePipeline()
    return time.perf_counter() - start


first = update()
fields = servermanager.Fetch(design, idx=0).GetFieldData()
print(f"minima, saddles, maxima: {vtk_to_numpy(fields.GetArray('CriticalCounts')).ravel()}")
for label in "EulerCharacteristic", "Missing", "Added":
    print(f"{label}: {int(fields.GetArray(label).GetTuple1(0))}")
handles[0].Center = [x + 0.01 for x in handles[0].Center]
print(f"first answer {first:.3f} s, after a point has moved {update():.3f} s")
handles[0].Center = [x - 0.01 for x in handles[0].Center]
update()

bounds = numpy.reshape(mesh.GetDataInformation().GetBounds(), (3, 2))
size = numpy.linalg.norm(numpy.diff(bounds))
towards = numpy.asarray(options.view) / numpy.linalg.norm(options.view)


def makeView():
    view = CreateRenderView()
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.CameraFocalPoint = bounds.mean(axis=1)
    view.CameraPosition = bounds.mean(axis=1) + 3 * size * towards
    view.CameraViewUp = options.up
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.45 * size
    return view


def mark(source, view, color):
    """Shows something in one color, a little nearer than the surface; a parallel projection does not show the difference."""
    shown = Show(source, view)
    shown.ColorArrayName = [None, ""]
    shown.Position = 0.01 * size * towards
    shown.AmbientColor = shown.DiffuseColor = color
    shown.Ambient = 0.3


def select(source, array, value):
    return Threshold(Input=source, Scalars=array, LowerThreshold=value - 0.5, UpperThreshold=value + 0.5)


left, right = makeView(), makeView()
function = OutputPort(design, 0)
values = vtk_to_numpy(servermanager.Fetch(design, idx=0).GetPointData().GetArray("DesignedScalars"))
for view in left, right:
    ColorBy(Show(function, view), ("POINTS", "DesignedScalars"))
    colors = GetColorTransferFunction("DesignedScalars")
    colors.ApplyPreset("Cool to Warm (Extended)", True)
    colors.RescaleTransferFunction(values.min(), values.max())
levels = list(numpy.linspace(values.min(), values.max(), options.contours + 2)[1:-1])
curves = Contour(Input=function, ContourBy=["POINTS", "DesignedScalars"], Isosurfaces=levels)
mark(Tube(Input=curves, Radius=0.0008 * size), left, [0.2, 0.2, 0.2])
found = servermanager.Fetch(design, idx=1).GetPointData()
types, prescribed = (vtk_to_numpy(found.GetArray(name)) for name in ("CriticalType", "Prescribed"))
for kind, color in [(0, [0.1, 0.2, 0.9]), (1, [0.1, 0.7, 0.2]), (3, [0.9, 0.1, 0.1])]:
    for asked, radius in [(0, 0.006), (1, 0.016)]:
        if ((types == kind) & (prescribed == asked)).any():
            some = select(select(OutputPort(design, 1), ["POINTS", "CriticalType"], kind), ["POINTS", "Prescribed"], asked)
            balls = Glyph(Input=some, GlyphType="Sphere", GlyphMode="All Points", ScaleFactor=2 * radius * size,
                          ScaleArray=["POINTS", "No scale array"], OrientationArray=["POINTS", "No orientation array"])
            mark(balls, left, color)
complex = MorseComplex(Input=function, ScalarArray=["POINTS", "DesignedScalars"])
for kind, color in [(0, [0.1, 0.3, 0.8]), (1, [0.8, 0.2, 0.1])]:
    lines = select(OutputPort(complex, 0), ["CELLS", "SeparatrixType"], kind)
    mark(Tube(Input=ExtractSurface(Input=lines), Radius=0.002 * size), right, color)

layout = CreateLayout("function and Morse complex")
layout.SplitHorizontal(0, 0.5)
AssignViewToLayout(left, layout, 1)
AssignViewToLayout(right, layout, 2)
layout.SetSize(1800, 900)
SaveScreenshot(options.picture, layout, ImageResolution=[1800, 900])
if options.state:
    servermanager.SaveState(options.state)

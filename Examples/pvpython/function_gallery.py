"""Functions designed on surfaces of genus 0 to 3, and the experiments of Figures 2 to 4 of the design paper.

usage: pvpython function_gallery.py PLUGIN DATA PICTURE.png

PLUGIN is SurfaceScalars.so, DATA the folder with elephant.vtk. Prints what was asked for, what was added and what is
missing, as a table in Markdown, and draws level sets and critical points: minima blue, saddles green, maxima red; small ones
were not asked for; in the first row the Morse complex as well. The surfaces of the paper are not to be had: a sphere, a torus, a plate with two holes and an elephant
with three handles stand in for them.
"""

import argparse
import math

import numpy
from paraview.simple import *
from vtk.util.numpy_support import vtk_to_numpy

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("plugin")
parser.add_argument("data")
parser.add_argument("picture")
options = parser.parse_args()
LoadPlugin(options.plugin, remote=False, ns=globals())  # from now on its filters are functions

MINIMUM, SADDLE, MAXIMUM = 0, 1, 3
TRUNK, RUMP = [0.184, 0.500, 0.089], [-0.162, -0.021, 0.056]
FEET = [[-0.132, -0.500, -0.030], [0.099, -0.475, -0.035], [0.297, -0.340, -0.226], [-0.340, -0.436, -0.180]]
FRONT, ABOVE, FLAT = ([0, 0.2, 1], [0, 1, 0], 0.42), ([0.3, 0.7, 0.9], [0, 1, 0], 0.42), ([0.2, -0.7, 0.9], [0, 1, 0], 0.5)


def elephant():
    return OpenDataFile(f"{options.data}/elephant.vtk")


def torus():
    """R = 0.7, r = 0.3, around the y axis."""
    shape = Superquadric(Toroidal=1, Thickness=0.43, Size=1, ThetaResolution=96, PhiResolution=48, ThetaRoundness=1,
                         PhiRoundness=1, Scale=[1, 1, 1])
    return Clean(Input=Triangulate(Input=shape))


def sphere():
    return Sphere(Radius=1, ThetaResolution=80, PhiResolution=80)


def plate():
    """Genus 2: the boundary of a box with two square holes, smoothed."""
    box = Wavelet(WholeExtent=[-36, 36, -24, 24, -8, 8], XFreq=0, YFreq=0, ZFreq=0)
    solid = Calculator(Input=box, ResultArrayName="solid", Function=(
        "min(min(min(28-abs(coordsX), 16-abs(coordsY)), 5-abs(coordsZ)),"
        "min(max(abs(coordsX-12)-6, abs(coordsY)-6), max(abs(coordsX+12)-6, abs(coordsY)-6)))"))
    return Smooth(Input=Contour(Input=solid, ContourBy=["POINTS", "solid"], Isosurfaces=[0.01]), NumberofIterations=200)


def points(kinds):
    """Points of these types, as ParaView's sources give them."""
    typed = []
    for kind, places in kinds.items():
        for place in places:
            source = PointSource(Center=[float(x) for x in place], Radius=0)
            typed.append(Calculator(Input=source, ResultArrayName="CriticalType", Function=str(kind)))
    return GroupDatasets(Input=typed)


def idOf(mesh, place):
    mesh.UpdatePipeline()
    places = vtk_to_numpy(servermanager.Fetch(mesh).GetPoints().GetData())
    return int(numpy.argmin(numpy.linalg.norm(places - place, axis=1)))


def naturalSaddles(mesh):
    """The critical points of the harmonic function between two points: one minimum, one maximum, two saddles per handle."""
    harmonic = PointSetScalarFunction(Input=mesh, Function="Harmonic", Weights="Cotangent")
    harmonic.ConstraintIds = [idOf(mesh, FEET[2]), idOf(mesh, RUMP)]
    harmonic.ConstraintValues = [0, 1]
    critical = MeshCriticalPoints(Input=harmonic, ScalarArray=["POINTS", "Harmonic"], PersistenceThreshold=1e-6)
    return OutputPort(critical, 1)


def circle(radius, count, first=0.0):
    """Around the axis of the torus. The first angle is in degrees."""
    angles = [math.radians(first) + 2 * math.pi * i / count for i in range(count)]
    return [[radius * math.cos(a), 0, radius * math.sin(a)] for a in angles]


leastSquares = {"ConstraintType": "LeastSquares", "EpsilonChoice": "Manual", "Epsilon": 1e9}
axes = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
CASES = [
    ("genus 0", sphere, {MAXIMUM: axes[:2], MINIMUM: axes[2:4], SADDLE: axes[4:]}, {}, ABOVE),
    ("genus 1", torus, {MAXIMUM: [[1, 0, 0]], MINIMUM: [[-1, 0, 0]], SADDLE: [[0.4, 0, 0], [-0.4, 0, 0]]}, {}, ABOVE),
    ("genus 2", plate, {MAXIMUM: [[28, 0, 0]], MINIMUM: [[-28, 0, 0]],
                        SADDLE: [[18, 0, 0], [6, 0, 0], [-6, 0, 0], [-18, 0, 0]]}, {"Energy": "Harmonic"}, FLAT),
    ("genus 3", elephant, {MAXIMUM: [TRUNK, RUMP], MINIMUM: FEET, SADDLE: [[-0.050, -0.047, -0.006]]}, {"CleanUp": 1}, FRONT),
    ("Fig. 2(a)", elephant, {MAXIMUM: [TRUNK, RUMP]}, {}, FRONT),
    ("Fig. 2(c)", elephant, {MINIMUM: [TRUNK, RUMP]}, {}, FRONT),
    ("Fig. 2(e)", elephant, {MAXIMUM: [TRUNK, RUMP], MINIMUM: [FEET[1], FEET[3]]}, {}, FRONT),
    ("Fig. 2(g)", torus, {SADDLE: circle(0.4, 4)}, {}, ABOVE),
    ("Fig. 3(a)", torus, {MAXIMUM: circle(1.0, 3)}, leastSquares, ABOVE),
    ("Fig. 3(c)", torus, {SADDLE: circle(0.4, 6)}, leastSquares, ABOVE),
    ("Fig. 3(e)", torus, {MAXIMUM: circle(1.0, 3), MINIMUM: circle(1.0, 3, 60),
                          SADDLE: circle(0.4, 6)}, leastSquares, ABOVE),
    ("Fig. 4, cubic, cleaned up", elephant, None, {"Approach": "Meshless", "Kernel": "Cubic", "CleanUp": 1}, FRONT),
]
COLUMNS = 4


def mark(source, view, color, towards):
    """Shows something in one color, a little nearer than the surface; a parallel projection does not show the difference."""
    shown = Show(source, view)
    shown.ColorArrayName = [None, ""]
    shown.Position = towards
    shown.AmbientColor = shown.DiffuseColor = color
    shown.Ambient = 0.3


def select(source, array, value):
    return Threshold(Input=source, Scalars=array, LowerThreshold=value - 0.5, UpperThreshold=value + 0.5)


def draw(number, name, mesh, design, look):
    bounds = numpy.reshape(mesh.GetDataInformation().GetBounds(), (3, 2))
    size = numpy.linalg.norm(numpy.diff(bounds))
    towards = numpy.asarray(look[0]) / numpy.linalg.norm(look[0])
    view = CreateRenderView()
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.CameraFocalPoint = bounds.mean(axis=1)
    view.CameraPosition = bounds.mean(axis=1) + 3 * size * towards
    view.CameraViewUp = look[1]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = look[2] * size
    title = Show(Text(Text=name), view)
    title.Color = [0, 0, 0]
    title.FontSize = 16
    array = f"f{number}"  # each has its own colors
    function = Calculator(Input=OutputPort(design, 0), ResultArrayName=array, Function="DesignedScalars")
    ColorBy(Show(function, view), ("POINTS", array))
    values = vtk_to_numpy(servermanager.Fetch(design, idx=0).GetPointData().GetArray("DesignedScalars"))
    GetColorTransferFunction(array).ApplyPreset("Cool to Warm", True)
    GetColorTransferFunction(array).RescaleTransferFunction(values.min(), values.max())
    levels = list(numpy.quantile(values, numpy.linspace(0, 1, 27)[1:-1]))
    curves = Contour(Input=function, ContourBy=["POINTS", array], Isosurfaces=levels)
    mark(Tube(Input=curves, Radius=0.001 * size), view, [0.15, 0.15, 0.15], 0.01 * size * towards)
    if name.startswith("genus"):
        complex = MorseComplex(Input=function, ScalarArray=["POINTS", array])
        for kind, color in [(0, [0.1, 0.3, 0.8]), (1, [0.8, 0.2, 0.1])]:
            lines = select(OutputPort(complex, 0), ["CELLS", "SeparatrixType"], kind)
            mark(Tube(Input=ExtractSurface(Input=lines), Radius=0.003 * size), view, color, 0.012 * size * towards)
    found = servermanager.Fetch(design, idx=1).GetPointData()
    types, prescribed = (vtk_to_numpy(found.GetArray(label)) for label in ("CriticalType", "Prescribed"))
    for kind, color in [(MINIMUM, [0.1, 0.2, 0.9]), (SADDLE, [0.1, 0.7, 0.2]), (MAXIMUM, [0.9, 0.1, 0.1])]:
        for asked, radius in [(0, 0.008), (1, 0.018)]:
            if ((types == kind) & (prescribed == asked)).any():
                some = select(select(OutputPort(design, 1), ["POINTS", "CriticalType"], kind), ["POINTS", "Prescribed"], asked)
                balls = Glyph(Input=some, GlyphType="Sphere", GlyphMode="All Points", ScaleFactor=2 * radius * size,
                              ScaleArray=["POINTS", "No scale array"], OrientationArray=["POINTS", "No orientation array"])
                balls.GlyphType.ThetaResolution = balls.GlyphType.PhiResolution = 24
                mark(balls, view, color, 0.02 * size * towards)
    return view


print("| | asked: minima, saddles, maxima | function: minima, saddles, maxima | missing | added | Euler characteristic |")
print("| --- | --- | --- | --- | --- | --- |")
views = []
for number, (name, surface, kinds, parameters, look) in enumerate(CASES):
    mesh = surface()
    mesh.UpdatePipeline()
    design = ScalarFunctionDesign(Input=mesh, CriticalPoints=points(kinds) if kinds else naturalSaddles(mesh), **parameters)
    design.UpdatePipeline()
    fields = servermanager.Fetch(design, idx=0).GetFieldData()
    counts = vtk_to_numpy(fields.GetArray("CriticalCounts")).ravel()
    numbers = {label: int(fields.GetArray(label).GetTuple1(0)) for label in ("Missing", "Added", "EulerCharacteristic")}
    asked = [len(kinds.get(kind, [])) for kind in (MINIMUM, SADDLE, MAXIMUM)] if kinds else [1, 6, 1]
    print(f"| {name} | {' / '.join(map(str, asked))} | {' / '.join(map(str, counts))} | {numbers['Missing']} "
          f"| {numbers['Added']} | {numbers['EulerCharacteristic']} |")
    views.append(draw(number, name, mesh, design, look))

layout = CreateLayout("gallery")
rows = -(-len(views) // COLUMNS)
cell = 0
for row in range(rows):
    left = rows - row
    below = layout.SplitVertical(cell, 1 / left) if left > 1 else None
    column = 2 * cell + 1 if below is not None else cell
    rest = 2 * cell + 2
    for i in range(COLUMNS):
        if COLUMNS - i > 1:
            layout.SplitHorizontal(column, 1 / (COLUMNS - i))
            AssignViewToLayout(views[row * COLUMNS + i], layout, 2 * column + 1)
            column = 2 * column + 2
        else:
            AssignViewToLayout(views[row * COLUMNS + i], layout, column)
    cell = rest
layout.SetSize(1800, 1350)
SaveScreenshot(options.picture, layout, ImageResolution=[1800, 1350])

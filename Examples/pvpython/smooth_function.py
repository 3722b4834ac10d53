"""Smooths a function on a mesh, keeps its persistent critical points, and draws it before and after.

usage: pvpython smooth_function.py PLUGIN MESH PICTURE.png [--array NAME | --height X Y Z] [--noise FRACTION]
                                   [--persistence FRACTION] [--contours N] [--charts CHARTS.png] [--view X Y Z] [--up X Y Z]
                                   [--zoom FACTOR] [--balls FRACTION]

PLUGIN is SurfaceScalars.so; MESH is anything that ParaView opens as triangles, quads or an image. f is an array of the mesh
or, otherwise, its height in a direction, by default z; noise of a fraction of its range can be added. Left: f, its contours
and critical points. Right: the same of the smoothed function, and the Morse complex: lines of steepest descent from the
saddles in blue, of steepest ascent in red. Minima are blue, saddles green, maxima red. The charts show how many critical
points are left above a persistence, and how smoothing depends on epsilon.
"""

import argparse

import numpy
from paraview.simple import *
from vtk.util.numpy_support import vtk_to_numpy

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("plugin")
parser.add_argument("mesh")
parser.add_argument("picture")
parser.add_argument("--array")
parser.add_argument("--height", nargs=3, type=float, default=[0, 0, 1])
parser.add_argument("--noise", type=float, default=0.0, help="standard deviation, a fraction of f's range")
parser.add_argument("--persistence", type=float, default=0.05)
parser.add_argument("--contours", type=int, default=24)
parser.add_argument("--charts")
parser.add_argument("--view", nargs=3, type=float, default=[0, 0, 1], help="from where to look")
parser.add_argument("--up", nargs=3, type=float, default=[0, 1, 0])
parser.add_argument("--zoom", type=float, default=1.0)
parser.add_argument("--balls", type=float, default=0.02, help="size of critical points, a fraction of the mesh's")
options = parser.parse_args()
LoadPlugin(options.plugin, remote=False, ns=globals())  # from now on its filters are functions

mesh = OpenDataFile(options.mesh)
mesh.UpdatePipeline()
if mesh.GetDataInformation().GetDataSetTypeAsString() != "vtkPolyData":
    mesh = ExtractSurface(Input=mesh)
name = options.array or "Height"
clean = mesh if options.array else PointSetScalarFunction(Input=mesh, Function="Height", Direction=options.height)
function = ProgrammableFilter(Input=clean, Script=f"""
import numpy
values = numpy.array(inputs[0].PointData["{name}"], float)
noise = numpy.random.default_rng(1).normal(0, {options.noise} * numpy.ptp(values), len(values))
output.PointData.append(values + noise, "f")
""")
smoothed = ConstrainedSmoothing(
    Input=function, ScalarArray=["POINTS", "f"], PersistenceThreshold=options.persistence, ResultArrayName="smooth")
smoothed.UpdatePipeline()

fields = servermanager.Fetch(smoothed, idx=0).GetFieldData()
for label in "InputCriticalCounts", "OutputCriticalCounts":
    print(f"{label}: {vtk_to_numpy(fields.GetArray(label)).ravel()} minima, saddles, maxima")
for label in "EulerCharacteristic", "Epsilon", "LInfinityError":
    print(f"{label}: {fields.GetArray(label).GetTuple1(0):.4g}")

bounds = numpy.reshape(mesh.GetDataInformation().GetBounds(), (3, 2))
size = numpy.linalg.norm(numpy.diff(bounds))
towards = numpy.asarray(options.view) / numpy.linalg.norm(options.view)
values = vtk_to_numpy(servermanager.Fetch(clean).GetPointData().GetArray(name)).astype(float)
levels = list(numpy.linspace(values.min(), values.max(), options.contours + 2)[1:-1])


def makeView():
    view = CreateRenderView()
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.CameraFocalPoint = bounds.mean(axis=1)
    view.CameraPosition = bounds.mean(axis=1) + 3 * size * towards
    view.CameraViewUp = options.up
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.5 * size / options.zoom
    return view


def select(source, array, kind):
    return Threshold(Input=source, Scalars=array, LowerThreshold=kind - 0.5, UpperThreshold=kind + 0.5)


def mark(source, view, color, lift):
    """Shows something in one color, a little nearer than the surface; a parallel projection does not show the difference."""
    shown = Show(source, view)
    shown.ColorArrayName = [None, ""]
    shown.Position = lift * size * towards
    shown.AmbientColor = shown.DiffuseColor = color
    shown.Ambient = 0.3


def draw(view, source, array, critical, ballSize):
    """The surface with contours and the critical points that are a filter's second output."""
    shown = Show(source, view)
    ColorBy(shown, ("POINTS", array))
    colors = GetColorTransferFunction(array)
    colors.ApplyPreset("Cool to Warm (Extended)", True)
    colors.RescaleTransferFunction(values.min(), values.max())
    curves = Contour(Input=source, ContourBy=["POINTS", array], Isosurfaces=levels)
    mark(Tube(Input=curves, Radius=0.0008 * size), view, [0.2, 0.2, 0.2], 0.001)
    points = OutputPort(critical, 1)
    types = vtk_to_numpy(servermanager.Fetch(critical, idx=1).GetPointData().GetArray("CriticalType"))
    for kind, color in [(0, [0.1, 0.2, 0.9]), (1, [0.1, 0.7, 0.2]), (3, [0.9, 0.1, 0.1])]:
        if (types == kind).any():
            ofKind = select(points, ["POINTS", "CriticalType"], kind)
            mark(Glyph(Input=ofKind, GlyphType="Sphere", GlyphMode="All Points", ScaleArray=["POINTS", "No scale array"],
                       OrientationArray=["POINTS", "No orientation array"], ScaleFactor=ballSize * size), view, color, 0.02)


left, right = makeView(), makeView()
before = MeshCriticalPoints(Input=function, ScalarArray=["POINTS", "f"])
before.UpdatePipeline()
draw(left, function, "f", before, 0.3 * options.balls)
draw(right, OutputPort(smoothed, 0), "smooth", smoothed, options.balls)
complex = MorseComplex(Input=OutputPort(smoothed, 0), ScalarArray=["POINTS", "smooth"])
for kind, color in [(0, [0.1, 0.3, 0.8]), (1, [0.8, 0.2, 0.1])]:
    lines = select(OutputPort(complex, 0), ["CELLS", "SeparatrixType"], kind)
    mark(Tube(Input=ExtractSurface(Input=lines), Radius=0.002 * size), right, color, 0.01)

layout = CreateLayout("before and after")
layout.SplitHorizontal(0, 0.5)
AssignViewToLayout(left, layout, 1)
AssignViewToLayout(right, layout, 2)
layout.SetSize(1800, 900)
SaveScreenshot(options.picture, layout, ImageResolution=[1800, 900])

if options.charts:
    def chart(source, columns, abscissa, title, bottom, logarithmic):
        view = CreateXYPlotView(ChartTitle=title, BottomAxisTitle=bottom)
        view.BottomAxisLogScale, view.LeftAxisLogScale = logarithmic
        shown = Show(source, view, "XYChartRepresentation")
        shown.AttributeType = "Row Data"
        shown.UseIndexForXAxis = 0
        shown.XArrayName = abscissa
        shown.SeriesVisibility = columns
        return view

    counts = chart(OutputPort(before, 3), ["PersistenceMinima", "PersistenceSaddles", "PersistenceMaxima"], "Threshold",
                   "critical points above a persistence", "fraction of f's range", (0, 1))
    corner = chart(OutputPort(smoothed, 2), ["Seminorm"], "Residual", "L-curve: semi-norm", "distance from f", (1, 1))
    validation = chart(OutputPort(smoothed, 2), ["GCV"], "Epsilon", "generalized cross-validation", "epsilon", (1, 1))
    charts = CreateLayout("charts")
    charts.SplitHorizontal(0, 0.33)
    charts.SplitHorizontal(2, 0.5)
    for view, cell in zip((counts, corner, validation), (1, 5, 6)):
        AssignViewToLayout(view, charts, cell)
    charts.SetSize(1800, 600)
    SaveScreenshot(options.charts, charts, ImageResolution=[1800, 600])

"""Finds the critical points of a function on a point cloud and draws them beside their probability.

usage: pvpython critical_points.py PLUGIN CLOUD PICTURE.png [--array NAME | --height X Y Z] [--persistence FRACTION]
                                   [--view X Y Z] [--up X Y Z]

PLUGIN is SurfaceScalars.so; CLOUD is a file of lines `x y z ...` (.xyz) or anything that ParaView opens. f is an array of
the cloud or, otherwise, its height in a direction, by default z. Critical points of less persistence than a fraction of
f's range, by default 0.02, are left out. Left: how probable it is that a sample is critical. Right: f, contours through
its saddles, minima (blue), saddles (green) and maxima (red).
"""

import argparse

import numpy
from paraview.simple import *
from vtk.util.numpy_support import vtk_to_numpy

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("plugin")
parser.add_argument("cloud")
parser.add_argument("picture")
parser.add_argument("--array")
parser.add_argument("--height", nargs=3, type=float, default=[0, 0, 1])
parser.add_argument("--persistence", type=float, default=0.02)
parser.add_argument("--neighbors", type=int, default=0)
parser.add_argument("--view", nargs=3, type=float, default=[1, -1, 0.5], help="from where to look")
parser.add_argument("--up", nargs=3, type=float, default=[0, 0, 1])
options = parser.parse_args()
LoadPlugin(options.plugin, remote=False, ns=globals())  # from now on its filters are functions


def read(path):
    if not path.endswith(".xyz"):
        return OpenDataFile(path)
    table = CSVReader(FileName=[path], HaveHeaders=0, FieldDelimiterCharacters=" ")
    return TableToPoints(Input=table, XColumn="Field 0", YColumn="Field 1", ZColumn="Field 2")


cloud = read(options.cloud)
name = options.array or "Height"
function = cloud if options.array else PointSetScalarFunction(Input=cloud, Function="Height", Direction=options.height)
critical = FuzzyCriticalPoints(
    Input=function, ScalarArray=["POINTS", name], PersistenceThreshold=options.persistence,
    NeighborCount=options.neighbors)
critical.UpdatePipeline()
samples, points = OutputPort(critical, 0), OutputPort(critical, 1)

found = servermanager.Fetch(critical, idx=1)
data = found.GetPointData()
types = vtk_to_numpy(data.GetArray("CriticalType"))
values = vtk_to_numpy(data.GetArray("ScalarValue"))
persistence = vtk_to_numpy(data.GetArray("Persistence"))
print(f"{(types == 0).sum()} minima, {(types == 1).sum()} saddles, {(types == 3).sum()} maxima, "
      f"{(types == 4).sum()} uncertain; index sum {found.GetFieldData().GetArray('IndexSum').GetTuple1(0):.0f}")
for i in numpy.argsort(-persistence)[:12]:
    kind = {0: "minimum", 1: "saddle", 3: "maximum", 4: "uncertain"}[types[i]]
    print(f"  {kind} at {tuple(round(c, 3) for c in found.GetPoint(i))}: f = {values[i]:.4g}, "
          f"persistence {persistence[i]:.3g}")

saddles = numpy.flatnonzero(types == 1)
strongest = saddles[numpy.argsort(-persistence[saddles])][:8]
contours = PointSetContour(Input=function, ScalarArray=["POINTS", name], ContourValues=sorted(values[strongest]))

bounds = cloud.GetDataInformation().GetBounds()
size = numpy.linalg.norm(numpy.diff(numpy.reshape(bounds, (3, 2))))
spacing = 1.2 * size / numpy.sqrt(cloud.GetDataInformation().GetNumberOfPoints())


def draw(source, view, array):
    """Shows points as flat discs, colored by an array."""
    shown = Show(source, view)
    shown.SetRepresentationType("Point Gaussian")
    shown.GaussianRadius = 0.7 * spacing
    shown.ShaderPreset = "Plain circle"
    ColorBy(shown, ("POINTS", array))


def mark(source, view, color):
    """Shows something in one color, a little nearer than the discs around it, which face the viewer."""
    shown = Show(source, view)
    shown.ColorArrayName = [None, ""]
    shown.Position = 2.5 * spacing * towards  # a parallel projection does not show the difference
    shown.AmbientColor = shown.DiffuseColor = color
    shown.Ambient = 0.3


def makeView():
    view = CreateRenderView(ViewSize=[900, 900])
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    return view


towards = numpy.asarray(options.view) / numpy.linalg.norm(options.view)
left, right = makeView(), makeView()
draw(samples, left, "CriticalProbability")
probability = GetColorTransferFunction("CriticalProbability")
probability.RGBPoints = [0, 0.88, 0.88, 0.86, 0.1, 0.98, 0.80, 0.35, 0.5, 0.90, 0.35, 0.10, 1, 0.55, 0.0, 0.10]
probability.ColorSpace = "RGB"
draw(samples, right, name)
GetColorTransferFunction(name).ApplyPreset("Cool to Warm (Extended)", True)
mark(Tube(Input=contours, Radius=0.0025 * size), right, [0.1, 0.1, 0.1])
for kind, color in [(0, [0.1, 0.2, 0.9]), (1, [0.1, 0.7, 0.2]), (3, [0.9, 0.1, 0.1]), (4, [0.5, 0.5, 0.5])]:
    if (types == kind).any():
        ofKind = Threshold(Input=points, Scalars=["POINTS", "CriticalType"],
                           LowerThreshold=kind - 0.5, UpperThreshold=kind + 0.5)
        mark(Glyph(Input=ofKind, GlyphType="Sphere", GlyphMode="All Points", ScaleArray=["POINTS", "No scale array"],
                   OrientationArray=["POINTS", "No orientation array"], ScaleFactor=0.022 * size), right, color)

center = numpy.reshape(bounds, (3, 2)).mean(axis=1)
for view in left, right:
    view.CameraFocalPoint = center
    view.CameraPosition = center + 3 * size * towards
    view.CameraViewUp = options.up
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.42 * size
    Render(view)
layout = CreateLayout("critical points")
layout.SplitHorizontal(0, 0.5)
AssignViewToLayout(left, layout, 1)
AssignViewToLayout(right, layout, 2)
layout.SetSize(1800, 900)
SaveScreenshot(options.picture, layout, ImageResolution=[1800, 900])

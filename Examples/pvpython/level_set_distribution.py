"""Shows how level sets cover a mesh and how far they are apart: for a function, with noise on it, and with plateaus.

usage: pvpython level_set_distribution.py PLUGIN MESH PICTURE.png CHARTS.png [--array NAME | --height X Y Z]
                                          [--tolerance SHARE] [--noise FRACTION] [--persistence FRACTION]
                                          [--view X Y Z] [--up X Y Z] [--zoom FACTOR]

PLUGIN is SurfaceScalars.so; MESH is anything that ParaView opens as triangles. f is an array of the mesh or its height in a
direction. Left to right: f, f with noise of a fraction of its range, and f cut off at a quarter and three quarters of its
range, each with the optimal level sets for a tolerance that is much too large, as lines, and what they cover in color. The
charts have the coverage of all three for the default tolerance and the distortion of 64 parts of the range.
"""

import argparse

import numpy
from paraview.simple import *
from vtk.util.numpy_support import vtk_to_numpy

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("plugin")
parser.add_argument("mesh")
parser.add_argument("picture")
parser.add_argument("charts")
parser.add_argument("--array")
parser.add_argument("--height", nargs=3, type=float, default=[0, 0, 1])
parser.add_argument("--tolerance", type=float, default=0.2, help="of the picture")
parser.add_argument("--noise", type=float, default=0.02, help="standard deviation, a fraction of f's range")
parser.add_argument("--persistence", type=float, default=0.1)
parser.add_argument("--view", nargs=3, type=float, default=[0, 0, 1], help="from where to look")
parser.add_argument("--up", nargs=3, type=float, default=[0, 1, 0])
parser.add_argument("--zoom", type=float, default=1.0)
options = parser.parse_args()
LoadPlugin(options.plugin, remote=False, ns=globals())  # from now on its filters are functions

mesh = OpenDataFile(options.mesh)
name = options.array or "Height"
function = mesh if options.array else PointSetScalarFunction(Input=mesh, Function="Height", Direction=options.height)
three = ProgrammableFilter(Input=function, Script=f"""
import numpy
values = numpy.array(inputs[0].PointData["{name}"], float)
lowest, size = values.min(), numpy.ptp(values)
noise = numpy.random.default_rng(1).normal(0, {options.noise} * size, len(values))
output.PointData.append(values, "smooth")
output.PointData.append(values + noise, "noisy")
output.PointData.append(numpy.clip(values, lowest + 0.25 * size, lowest + 0.75 * size), "plateaus")
""")
three.UpdatePipeline()  # which imports functions called size and such
COLORS = {"smooth": [0.1, 0.3, 0.8], "noisy": [0.8, 0.2, 0.1], "plateaus": [0.1, 0.6, 0.2]}

bounds = numpy.reshape(mesh.GetDataInformation().GetBounds(), (3, 2))
size = numpy.linalg.norm(numpy.diff(bounds))
towards = numpy.asarray(options.view) / numpy.linalg.norm(options.view)


def distribution(array, tolerance):
    """The filter, run."""
    result = LevelSetDistribution(
        Input=three, ScalarArray=["POINTS", array], CoverageTolerance=tolerance, PersistenceThreshold=options.persistence,
        MaximumIntervals=64)
    result.UpdatePipeline()
    return result


def fieldOf(result, label):
    return vtk_to_numpy(servermanager.Fetch(result, idx=0).GetFieldData().GetArray(label))


def draw(array):
    """A view of what a few level sets cover."""
    view = CreateRenderView()
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.CameraFocalPoint = bounds.mean(axis=1)
    view.CameraPosition = bounds.mean(axis=1) + 3 * size * towards
    view.CameraViewUp = options.up
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.5 * size / options.zoom
    result = distribution(array, options.tolerance)
    values = fieldOf(result, "OptimalIsoValues").tolist()
    print(f"{array}, tolerance {options.tolerance}: {len(values)} iso-values cover {fieldOf(result, 'GlobalCoverage')[0]:.3f}")
    shown = Show(OutputPort(result, 0), view)
    ColorBy(shown, ("CELLS", "Covered"))
    shown.SetScalarBarVisibility(view, False)
    colors = GetColorTransferFunction("Covered")
    colors.RGBPoints = [0, 0.9, 0.88, 0.84, 1, 0.55, 0.7, 0.95]
    curves = Contour(Input=OutputPort(result, 0), ContourBy=["POINTS", array], Isosurfaces=values)
    shown = Show(Tube(Input=curves, Radius=0.001 * size), view)
    shown.ColorArrayName = [None, ""]
    shown.AmbientColor = shown.DiffuseColor = [0.1, 0.1, 0.1]
    shown.Position = 0.002 * size * towards  # nearer; a parallel projection does not show the difference
    return view


def together(views, width, height, path):
    layout = CreateLayout(path)
    layout.SplitHorizontal(0, 1 / len(views))
    cells = [1]
    for left in range(len(views) - 1, 1, -1):
        cells.append(layout.SplitHorizontal(2 * cells[-1] if len(cells) > 1 else 2, 1 / left))
    cells.append(cells[-1] + 1)
    for view, cell in zip(views, cells):
        AssignViewToLayout(view, layout, cell)
    layout.SetSize(width, height)
    SaveScreenshot(path, layout, ImageResolution=[width, height])


def chart(results, port, abscissa, ordinate, title, bottom, logarithmic):
    view = CreateXYPlotView(ChartTitle=title, BottomAxisTitle=bottom)
    view.BottomAxisLogScale, view.LeftAxisLogScale = logarithmic
    for array, result in results.items():
        shown = Show(OutputPort(result, port), view, "XYChartRepresentation")
        shown.AttributeType = "Row Data"
        shown.UseIndexForXAxis = 0
        shown.XArrayName = abscissa
        shown.SeriesVisibility = [ordinate]
        shown.SeriesLabel = [ordinate, array]
        shown.SeriesColor = [ordinate, *map(str, COLORS[array])]
    return view


together([draw(array) for array in COLORS], 1800, 700, options.picture)
results = {array: distribution(array, 1e-4) for array in COLORS}
for array, result in results.items():
    print(f"{array}: {len(fieldOf(result, 'OptimalIsoValues'))} iso-values cover {fieldOf(result, 'GlobalCoverage')[0]:.4f}; "
          f"{fieldOf(result, 'LeftOutIntervals')[0]} of {fieldOf(result, 'DistortionIntervals')[0]} intervals left out")
together([chart(results, 1, "IsoValueCount", "Coverage", "coverage", "iso-values", (1, 0)),
          chart(results, 2, "IsoValue", "Distortion", "distance to the next level set", "iso-value", (0, 1))],
         1800, 600, options.charts)

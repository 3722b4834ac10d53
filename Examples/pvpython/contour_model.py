"""Draws level sets of models: on a coarse mesh beside those of ParaView's Contour, and on a terrain.

usage: pvpython contour_model.py PLUGIN TERRAIN PICTURE.png [--array Elevation] [--centers N] [--interval METRES]
                                 [--tolerance METRES] [--detail SHARE]

PLUGIN is SurfaceScalars.so; TERRAIN is an image with a point array, such as Data/jacksboro.vtk. Left: a function on a coarse
sphere by Contour, which is linear in each triangle. Middle: by Meshless Contour, from a model of the same function. Right: a
detail of the terrain with level sets of a model of it that has N centers. Prints how much of the terrain the function was
computed at, and the time beside computing it at all points for Contour.
"""

import argparse
import time

import numpy
from paraview.simple import *
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("plugin")
parser.add_argument("terrain")
parser.add_argument("picture")
parser.add_argument("--array", default="Elevation")
parser.add_argument("--centers", type=int, default=1000)
parser.add_argument("--interval", type=float, default=100.0)
parser.add_argument("--tolerance", type=float, default=1.0)
parser.add_argument("--detail", type=float, default=0.2, help="width of the detail, of the terrain's")
options = parser.parse_args()
LoadPlugin(options.plugin, remote=False, ns=globals())  # from now on its filters are functions


def samples(points, values):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=float), deep=True))
    array = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=float), deep=True)
    array.SetName(options.array)
    data.GetPointData().SetScalars(array)
    producer = TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


def model_of(points, values):
    extend = RBFExtend(Input=samples(points, values), Scheme="GlobalRBF", GridDimensions=[2, 2, 2])
    return OutputPort(extend, 1)


def timed(proxy):
    start = time.perf_counter()
    proxy.UpdatePipeline()
    return time.perf_counter() - start


def wave(p):
    return numpy.sin(4 * p[:, 0] + p[:, 1]) + numpy.cos(5 * p[:, 1]) * p[:, 2] + numpy.sin(6 * p[:, 2] + 1)


def on_sphere():
    """A coarse sphere, the level sets that are linear in its triangles, and those of the model."""
    generator = numpy.random.RandomState(1)
    places = generator.normal(size=(800, 3))
    places /= numpy.linalg.norm(places, axis=1)[:, None]
    model = model_of(places, wave(places))
    sphere = Sphere(Radius=1, ThetaResolution=20, PhiResolution=14)
    levels = list(numpy.linspace(-2, 2, 11))
    linear = Contour(
        Input=RBFEvaluate(Input=model, Target=sphere), ContourBy=["POINTS", options.array], Isosurfaces=levels)
    curves = MeshlessContour(Input=model, Surface=sphere, ContourValues=levels, Tolerance=1e-4)
    return sphere, linear, curves


def on_terrain():
    """The terrain as triangles, and the level sets of a model of it."""
    image = OpenDataFile(options.terrain)
    image.UpdatePipeline()
    data = image.GetClientSideObject().GetOutputDataObject(0)
    columns, rows, _ = data.GetDimensions()
    heights = vtk_to_numpy(data.GetPointData().GetArray(options.array)).reshape(rows, columns)
    x, y, _ = (data.GetOrigin()[i] + data.GetSpacing()[i] * numpy.arange(data.GetDimensions()[i]) for i in range(3))
    # One sample at a random place in each cell of a grid.
    generator = numpy.random.RandomState(1)
    across = max(2, round(numpy.sqrt(options.centers * columns / rows)))
    along = max(2, options.centers // across)
    i, j = (edge.ravel() for edge in numpy.meshgrid(numpy.arange(across), numpy.arange(along)))
    i = ((i + generator.uniform(0.2, 0.8, i.shape)) / across * columns).astype(int)
    j = ((j + generator.uniform(0.2, 0.8, j.shape)) / along * rows).astype(int)
    model = model_of(numpy.column_stack([x[i], y[j], numpy.zeros(len(i))]), heights[j, i])

    surface = Triangulate(Input=ExtractSurface(Input=image))
    surface.UpdatePipeline()
    low, high = options.interval * numpy.ceil(heights.min() / options.interval), heights.max()
    levels = list(numpy.arange(low, high, options.interval))
    middle = [levels[len(levels) // 2]]
    curves = MeshlessContour(Input=model, Surface=surface, ContourValues=middle, Tolerance=options.tolerance)
    ours = timed(curves)
    fields = servermanager.Fetch(curves).GetFieldData()
    share, count = (fields.GetArray(name).GetTuple1(0) for name in ("EvaluatedShare", "Evaluations"))
    evaluated = RBFEvaluate(Input=model, Target=surface, ResultArrayName="Model")
    linear = Contour(Input=evaluated, ContourBy=["POINTS", "Model"], Isosurfaces=middle)
    theirs = timed(evaluated)
    theirs += timed(linear)
    print(f"{columns * rows} points, {len(i)} centers, one level: computed at {100 * share:.2f}% of the points, "
          f"{count / (columns * rows):.3f} times as often as there are points in all")
    print(f"{ours:.2f} s; at all points, then Contour: {theirs:.2f} s, {theirs / ours:.1f} times")
    curves.ContourValues = levels
    print(f"{len(levels)} levels {timed(curves):.2f} s")
    return image, curves


def show(data, view, color, width):
    display = Show(data, view)
    display.ColorArrayName = [None, ""]
    display.DiffuseColor = display.AmbientColor = color
    display.LineWidth = width
    return display


views = [CreateView("RenderView") for _ in range(3)]
for view in views:
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0

sphere, linear, curves = on_sphere()
for view, lines in zip(views, (linear, curves)):
    display = show(sphere, view, [0.95, 0.93, 0.88], 1)
    display.SetRepresentationType("Surface With Edges")
    display.EdgeColor = [0.7, 0.7, 0.7]
    towards = [2.2, -1.6, 1.4]
    show(lines, view, [0.75, 0.1, 0.1], 3).Position = [0.003 * x for x in towards]  # nearer, or triangles hide them in part
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = towards, [0, 0, 0], [0, 0, 1]
    view.CameraParallelProjection, view.CameraParallelScale = 1, 1.05

terrain, curves = on_terrain()
display = Show(terrain, views[2])
display.SetRepresentationType("Surface")
ColorBy(display, ("POINTS", options.array))
colors = GetColorTransferFunction(options.array)
colors.ApplyPreset("Grayscale", True)
low, high = terrain.PointData[options.array].GetRange()
colors.RescaleTransferFunction(low - 0.5 * (high - low), high)  # no black, on which curves are hard to see
show(curves, views[2], [0.75, 0.1, 0.1], 2)
bounds = numpy.reshape(terrain.GetDataInformation().GetBounds(), (3, 2))
center, width = bounds.mean(axis=1), options.detail * (bounds[0, 1] - bounds[0, 0])
views[2].CameraPosition, views[2].CameraFocalPoint = [center[0], center[1], 10 * width], list(center)
views[2].CameraViewUp, views[2].CameraParallelProjection, views[2].CameraParallelScale = [0, 1, 0], 1, 0.5 * width

layout = CreateLayout("model")
layout.SplitHorizontal(0, 1 / 3)
layout.SplitHorizontal(2, 0.5)
for view, place in zip(views, (1, 5, 6)):
    layout.AssignView(place, view)
layout.SetSize(2100, 700)
SaveScreenshot(options.picture, layout, ImageResolution=[2100, 700])

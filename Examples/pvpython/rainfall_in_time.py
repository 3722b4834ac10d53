"""Maps the rain of twelve months in Colorado, with one factorization, and tells whether its maxima are kept.

usage: pvpython rainfall_in_time.py PLUGIN DATA_FOLDER PICTURE.png

PLUGIN is SurfaceScalars.so; DATA_FOLDER holds colorado_rain.vtk and colorado_terrain.vtk (Utilities/fetch-data.sh). Each
station is turned off in turn, in each month, and predicted from the others: Table 5 of the design paper. Then the stations
become points of the terrain, whose mesh shows where each method puts the maxima of the rain. A station is a maximum of the
measurements if it has more rain than all its neighbors in a Delaunay triangulation of the stations. The picture shows the
three wettest months and the driest.
"""

import os
import sys
import time

import numpy
import vtk
from paraview.simple import *
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import Delaunay
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

if len(sys.argv) != 4:
    sys.exit(__doc__)
plugin, data, picture = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())  # from now on its filters are functions

stations = LegacyVTKReader(FileNames=[os.path.join(data, "colorado_rain.vtk")])
terrain = LegacyVTKReader(FileNames=[os.path.join(data, "colorado_terrain.vtk")])
MONTHS = [f"Rain{month:02}" for month in range(1, 13)]
NAMES = "Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec".split()

network = servermanager.Fetch(stations)
places = vtk_to_numpy(network.GetPoints().GetData())[:, :2]
rain = {month: vtk_to_numpy(network.GetPointData().GetArray(month)) for month in MONTHS}
year = int(network.GetFieldData().GetArray("Year").GetTuple1(0))
spacing = numpy.sqrt(numpy.prod(numpy.ptp(places, axis=0)) / len(places))
print(f"{len(places)} stations, one in {spacing:.0f} x {spacing:.0f} km, {year}")


def extend(source, target, **properties):
    return RBFExtend(Input=source, ScalarArray=["POINTS", MONTHS[0]], Target=target, Scheme="GlobalRBF",
                     ResultArrayName="Rain", **properties)


def producer(positions, **arrays):
    """A source of points, in the plane if they have no height, with point arrays, and its data."""
    dataset = vtk.vtkPolyData()
    dataset.SetPoints(vtk.vtkPoints())
    dataset.GetPoints().SetData(numpy_to_vtk(numpy.pad(positions, [(0, 0), (0, 3 - positions.shape[1])]), deep=True))
    for name, values in arrays.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        dataset.GetPointData().AddArray(array)
    result = TrivialProducer()
    result.GetClientSideObject().SetOutput(dataset)
    return result, dataset


# Each station predicted from the others.
def left_out(predict):
    """The largest error of each month as a fraction of its largest rain, and the root mean square of all, in cm."""
    errors = [numpy.maximum(predict(month), 0) - rain[month] for month in MONTHS]
    largest = [abs(error).max() / rain[month].max() for error, month in zip(errors, MONTHS)]
    return largest, numpy.sqrt(numpy.mean(numpy.square(errors)))


distances = numpy.linalg.norm(places[:, None] - places[None], axis=2)
numpy.fill_diagonal(distances, numpy.inf)
nearest = distances.argmin(axis=1)
weights = 1 / distances ** 2


def piecewise_linear(month):
    """Over the Delaunay triangles of the other stations; outside of them the nearest station."""
    predictions = rain[month][nearest].copy()
    for station in range(len(places)):
        others = numpy.arange(len(places)) != station
        predicted = LinearNDInterpolator(places[others], rain[month][others])(places[station])[0]
        if numpy.isfinite(predicted):
            predictions[station] = predicted
    return predictions


def radial(**properties):
    """Predictions of a month by RBFExtend, whose second output holds the errors at the stations turned off."""
    filter = extend(stations, stations, ComputeLeaveOneOutErrors=1, **properties)

    def predict(month):
        filter.ScalarArray = ["POINTS", month]
        filter.UpdatePipeline()
        return rain[month] - vtk_to_numpy(servermanager.Fetch(filter, idx=1).GetPointData().GetArray("LeaveOneOutError"))
    return predict


gaussians = {width: left_out(radial(Kernel="Gaussian", KernelWidth=width * spacing)) for width in (0.2, 0.3, 0.5, 0.7, 1)}
width = min(gaussians, key=lambda width: gaussians[width][1])
table = {
    "nearest station (Voronoi)": left_out(lambda month: rain[month][nearest]),
    "linear (Delaunay)": left_out(piecewise_linear),
    "inverse squared distance": left_out(lambda month: weights @ rain[month] / weights.sum(axis=1)),
    "RBF Linear": left_out(radial(Kernel="Linear")),
    "RBF Cubic": left_out(radial(Kernel="Cubic")),
    f"RBF Gaussian, width {width * spacing:.0f} km": gaussians[width],
}
print("\nlargest error / largest rain  " + "   ".join(NAMES) + "  rms, cm")
for label, (largest, root_mean_square) in table.items():
    print(f"{label:28} " + " ".join(f"{value:5.2f}" for value in largest) + f" {root_mean_square:8.3f}")
print("root mean square, cm, of Gaussians by width: "
      + ", ".join(f"{width * spacing:.0f} km {errors[1]:.3f}" for width, errors in gaussians.items()))

# The time of the first month and of the others, for these stations and for more than there are.
x, y = numpy.random.default_rng(1).uniform(-300, 300, (2, 1600))
showers = {month: 3 + numpy.sin(x / 90 + phase) * numpy.cos(y / 60 - phase) for phase, month in enumerate(MONTHS)}
invented, _ = producer(numpy.column_stack([x, y]), **showers)
print()
for label, source in [(f"{len(places)} stations", stations), (f"{len(x)} invented ones", invented)]:
    filter = extend(source, terrain, Kernel="Linear")
    one_place = extend(source, producer(numpy.zeros((1, 2)))[0], Kernel="Linear")
    source.UpdatePipeline()
    for goal, filter in [("at one place", one_place), ("on the terrain", filter)]:
        seconds = []
        for month in MONTHS:
            filter.ScalarArray = ["POINTS", month]
            start = time.perf_counter()
            filter.UpdatePipeline()
            seconds.append(time.perf_counter() - start)
        later = numpy.median(seconds[1:])
        print(f"{label}, {goal}: first month {1e3 * seconds[0]:.1f} ms, later ones {1e3 * later:.1f} ms, "
              f"{seconds[0] / later:.1f} times less")

# The maxima on the terrain.
relief = servermanager.Fetch(terrain)
nodes = numpy.array([relief.GetPoint(i) for i in range(relief.GetNumberOfPoints())])[:, :2]
inside = (places > nodes.min(axis=0)).all(axis=1) & (places < nodes.max(axis=0)).all(axis=1)
vertices = numpy.concatenate([places[inside], nodes])
vertices = vertices[numpy.sort(numpy.unique(vertices, axis=0, return_index=True)[1])]
triangles = Delaunay(vertices).simplices
cells = numpy.column_stack([numpy.full(len(triangles), 3), triangles]).ravel()


def triangulated(**arrays):
    result, dataset = producer(vertices, **arrays)
    dataset.SetPolys(vtk.vtkCellArray())
    dataset.GetPolys().SetCells(len(triangles), numpy_to_vtkIdTypeArray(cells.astype(numpy.int64), deep=True))
    return result


start, neighbor = Delaunay(places).vertex_neighbor_vertices
neighbors = [neighbor[start[i]:start[i + 1]] for i in range(len(places))]
rank = numpy.cumsum(inside) - 1  # of a station inside among the vertices


def maxima_on_mesh(source):
    critical = MeshCriticalPoints(Input=source, ScalarArray=["POINTS", "Rain"])
    return vtk_to_numpy(servermanager.Fetch(critical, idx=0).GetPointData().GetArray("CriticalType")) == 3


def inverse_distances(month):
    squares = ((vertices[:, None] - places[None]) ** 2).sum(axis=2)
    near = 1 / numpy.maximum(squares, 1e-12)
    return triangulated(Rain=near @ rain[month] / near.sum(axis=1))


def on_mesh(**properties):
    filter = extend(stations, triangulated(), **properties)

    def step(month):
        filter.ScalarArray = ["POINTS", month]
        return filter
    return step


measured = {month: [i for i in numpy.flatnonzero(inside) if (rain[month][i] > rain[month][neighbors[i]]).all()]
            for month in MONTHS}
print(f"\nmaxima of the stations: {sum(map(len, measured.values()))} in all months; of a mesh of {len(vertices)} points:")
print("                             at those stations   at other stations   elsewhere   largest misfit, cm")
for label, step in [("inverse squared distance", inverse_distances), ("RBF Linear", on_mesh(Kernel="Linear")),
                    ("RBF Cubic", on_mesh(Kernel="Cubic")),
                    (f"RBF Gaussian, width {width * spacing:.0f} km", on_mesh(Kernel="Gaussian", KernelWidth=width * spacing))]:
    kept = other = elsewhere = 0
    misfit = 0.0
    for month in MONTHS:
        source = step(month)
        found = maxima_on_mesh(source)
        values = vtk_to_numpy(servermanager.Fetch(source).GetPointData().GetArray("Rain"))
        misfit = max(misfit, abs(values[:inside.sum()] - rain[month][inside]).max())
        kept += found[rank[measured[month]]].sum()
        other += found[:inside.sum()].sum() - found[rank[measured[month]]].sum()
        elsewhere += found[inside.sum():].sum()
    print(f"{label:28} {kept:17} {other:19} {elsewhere:11} {misfit:20.1e}", flush=True)

# The maps.
wet = sorted(MONTHS, key=lambda month: -rain[month].mean())
most = max(rain[month].max() for month in MONTHS)
RAISE = 0.012  # a meter of height in the picture, in km
towards = numpy.array([0, -0.5, 0.87])
layout = CreateLayout("months")
layout.SplitHorizontal(0, 0.5)
layout.SplitVertical(1, 0.5)
layout.SplitVertical(2, 0.5)
for month, cell in zip(sorted(wet[:3] + wet[-1:]), (3, 5, 4, 6)):
    view = CreateRenderView()
    AssignViewToLayout(view, layout, cell)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    mapped = extend(stations, terrain, Kernel="Linear", ClampToRange=1)
    mapped.ScalarArray = ["POINTS", month]
    surface = GenerateSurfaceNormals(Input=ExtractSurface(Input=WarpByScalar(
        Input=mapped, Scalars=["POINTS", "Elevation"], ScaleFactor=RAISE)))
    shown = Show(surface, view)
    ColorBy(shown, ("POINTS", "Rain"))
    shown.Ambient = 0.1
    colors = GetColorTransferFunction("Rain")
    colors.ApplyPreset("Blues", True)
    colors.InvertTransferFunction()
    colors.RescaleTransferFunction(0, 5 * round(0.12 * most))
    if cell == 6:
        bar = GetScalarBar(colors, view)
        bar.Title, bar.ComponentTitle = "cm", ""
        bar.Orientation, bar.WindowLocation, bar.Position = "Vertical", "Any Location", [0.91, 0.3]
        bar.ScalarBarLength, bar.ScalarBarThickness = 0.4, 16
        bar.TitleFontSize = bar.LabelFontSize = 16
        bar.TitleColor = bar.LabelColor = [0, 0, 0]
        bar.RangeLabelFormat = bar.LabelFormat = "%.0f"
        bar.AutomaticLabelFormat = 0
        shown.SetScalarBarVisibility(view, True)
    gauges = numpy.column_stack([places, RAISE * vtk_to_numpy(network.GetPointData().GetArray("Height"))])
    for positions, color, size in [(gauges, [0.3, 0.3, 0.3], 4), (gauges[measured[month]], [0.9, 0.2, 0.1], 12)]:
        balls = Glyph(Input=producer(positions)[0], GlyphType="Sphere", GlyphMode="All Points", ScaleFactor=size,
                      ScaleArray=["POINTS", "No scale array"], OrientationArray=["POINTS", "No orientation array"])
        drawn = Show(balls, view)
        drawn.AmbientColor = drawn.DiffuseColor = color
        drawn.Position = list(100 * towards)  # nearer than the terrain; a parallel projection does not show the difference
    label = Show(Text(Text=f"{NAMES[int(month[4:]) - 1]} {year}"), view)
    label.Color, label.FontSize = [0, 0, 0], 22
    Render(view)  # the first time it moves the camera
    view.CameraFocalPoint = [0, -10, 25]
    view.CameraPosition = list(view.CameraFocalPoint + 1000 * towards)
    view.CameraViewUp = [0, 0, 1]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 285
layout.SetSize(1600, 1000)
SaveScreenshot(picture, layout, ImageResolution=[1600, 1000])

"""Makes the surface of a molecule from a coarse grid of its density, and finds where its electric potential peaks.

usage: pvpython molecular_surface.py PLUGIN MOLECULE.pqr PICTURE.png [--spacing ANGSTROM] [--refine N] [--logarithm]
                                     [--neighbors N] [--screening ANGSTROM] [--persistence FRACTION] [--centers FRACTION]
                                     [--zoom FACTOR]

PLUGIN is SurfaceScalars.so; MOLECULE.pqr lists atoms with charges and radii (Utilities/fetch-data.sh fetches fas2.pqr and
achbp.pqr). The density is a sum over the atoms, exp(2.35 (1 - (distance / radius)^2)), and the surface is where it is 1: an
atom by itself gets a sphere of its radius. The density is sampled on a coarse grid only and brought to one that is N times
finer by RBFExtend, where the surface can be; a table compares the surface with the one from the density computed on the
fine grid. With --logarithm the logarithm of the density is sampled. The potential of the charges on the surface is
approximated by MeshlessApproximation, which keeps the critical points above a persistence, a fraction of the range, and has
a fraction of the points as centers besides.

Left: the atoms, colored by their charge; middle: the potential on the surface and its level sets; right: critical points
and the Morse complex of its approximation: lines of steepest descent from the saddles in blue, of steepest ascent in red;
minima blue, saddles green, maxima red.
"""

import argparse
import time

import numpy
import vtk
from paraview.simple import *
from scipy import ndimage, spatial
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("plugin")
parser.add_argument("molecule")
parser.add_argument("picture")
parser.add_argument("--spacing", type=float, default=0.5, help="of the coarse grid")
parser.add_argument("--refine", type=int, default=2)
parser.add_argument("--logarithm", action="store_true")
parser.add_argument("--neighbors", type=int, default=128, help="of a fine node on the coarse grid: fewer are faster")
parser.add_argument("--screening", type=float, default=numpy.inf, help="length over which salt in the water screens a charge")
parser.add_argument("--persistence", type=float, default=0.05)
parser.add_argument("--centers", type=float, default=0.04)
parser.add_argument("--zoom", type=float, default=1.2)
options = parser.parse_args()
LoadPlugin(options.plugin, remote=False, ns=globals())  # from now on its filters are functions

DECAY = 2.35
MARGIN = 4.0  # Angstrom around the centers of the atoms
COULOMB = 14.3996 / 80  # volt Angstrom per elementary charge, in water

with open(options.molecule) as file:
    fields = numpy.array([line.split()[5:10] for line in file if line.startswith("ATOM")], dtype=float)
atoms, charges, radii = fields[:, :3], fields[:, 3], fields[:, 4]
origin = atoms.min(axis=0) - MARGIN
cells = numpy.ceil((numpy.ptp(atoms, axis=0) + 2 * MARGIN) / options.spacing).astype(int) * options.refine
step = options.spacing / options.refine


def producer(dataset, name=None, values=None):
    if values is not None:
        array = numpy_to_vtk(values.ravel(), deep=True)
        array.SetName(name)
        dataset.GetPointData().AddArray(array)
    result = TrivialProducer()
    result.GetClientSideObject().SetOutput(dataset)
    return result


def polydata(positions):
    data = vtk.vtkPolyData()
    data.SetPoints(vtk.vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(positions, deep=True))
    return data


def image(values, size):
    grid = vtk.vtkImageData()
    grid.SetDimensions(*values.shape[::-1])
    grid.SetOrigin(*origin)
    grid.SetSpacing(size, size, size)
    return producer(grid, "Density", values)


def density():
    """On the fine grid, as an array [z, y, x]; an atom reaches as far as it adds more than 1e-8."""
    axes = [first + step * numpy.arange(count + 1) for first, count in zip(origin, cells)]
    total = numpy.zeros(cells[::-1] + 1)
    for atom, radius in zip(atoms, radii):
        if radius > 0:
            reach = radius * numpy.sqrt(1 + 18 / DECAY)
            near = [slice(*numpy.searchsorted(axis, (place - reach, place + reach))) for axis, place in zip(axes, atom)]
            x, y, z = [numpy.exp(-DECAY * ((axis[part] - place) / radius) ** 2)
                       for axis, part, place in zip(axes, near, atom)]
            total[near[2], near[1], near[0]] += numpy.exp(DECAY) * z[:, None, None] * y[None, :, None] * x
    return total


def around_surface(coarse, level):
    """The fine nodes of those coarse cells around which the coarse values lie on both sides of the level."""
    lowest, highest = (choose(coarse, 4, origin=-1) for choose in (ndimage.minimum_filter, ndimage.maximum_filter))
    cell = [numpy.minimum(numpy.arange(count + 1) // options.refine, count // options.refine - 1) for count in cells[::-1]]
    return ((lowest < level) & (highest > level))[numpy.ix_(*cell)]


def extended(coarse, wanted):
    """The function of the coarse grid's values at the fine nodes that are wanted."""
    target = producer(polydata(origin + step * numpy.argwhere(wanted)[:, ::-1]))
    result = RBFExtend(Input=image(coarse, options.spacing), ScalarArray=["POINTS", "Density"], Target=target,
                       Scheme="LocalRBF", Kernel="Gaussian", KernelWidth=3 * options.spacing, NeighborCount=options.neighbors)
    return vtk_to_numpy(servermanager.Fetch(result).GetPointData().GetArray("Density"))


def iso_surface(values, level):
    return Contour(Input=image(values, step), ContourBy=["POINTS", "Density"], Isosurfaces=[level],
                   ComputeNormals=0, ComputeScalars=0)


def describe(label, source, truth):
    surface, reference = servermanager.Fetch(source), servermanager.Fetch(truth)
    properties = vtk.vtkMassProperties()
    properties.SetInputData(surface)
    euler = surface.GetNumberOfPoints() - surface.GetNumberOfCells() // 2
    away = vtk.vtkHausdorffDistancePointSetFilter()
    away.SetInputData(0, surface)
    away.SetInputData(1, reference)
    away.SetTargetDistanceMethodToPointToCell()
    away.Update()
    distances = numpy.concatenate([vtk_to_numpy(away.GetOutput(i).GetPointData().GetArray("Distance")) for i in (0, 1)])
    print(f"{label:28} {surface.GetNumberOfPoints():8} {euler:6} {properties.GetSurfaceArea():9.1f} "
          f"{properties.GetVolume():9.1f} {distances.mean():8.4f} {numpy.quantile(distances, 0.99):8.4f} {distances.max():9.3f}",
          flush=True)


# The surface.
fine = density()
if options.logarithm:
    fine = numpy.log(fine + 1e-3)
level = numpy.log(1 + 1e-3) if options.logarithm else 1.0
coarse = fine[(slice(None, None, options.refine),) * 3]
linear, cubic = (ndimage.zoom(coarse, numpy.divide(fine.shape, coarse.shape), order=degree, mode="mirror")
                 for degree in (1, 3))
wanted = around_surface(coarse, level)
print(f"{len(atoms)} atoms, {coarse.size} samples {options.spacing} Angstrom apart, "
      f"{wanted.sum()} of {fine.size} fine nodes wanted")
start = time.perf_counter()
radial = linear.copy()
radial[wanted] = extended(coarse, wanted)
print(f"RBFExtend: {time.perf_counter() - start:.1f} s")
truth, ours = iso_surface(fine, level), iso_surface(radial, level)
print("                              points  Euler      area    volume     mean      99%   largest distance")
for label, surface in [("density on the fine grid", truth), ("linear from the coarse one", iso_surface(linear, level)),
                       ("cubic spline", iso_surface(cubic, level)), ("LocalRBF from the coarse one", ours)]:
    describe(label, surface, truth)


# The potential on the largest component.
def potential(places):
    total = numpy.zeros(len(places))
    for part in numpy.array_split(numpy.arange(len(places)), 1 + len(places) * len(atoms) // 10 ** 7):
        distances = spatial.distance.cdist(places[part], atoms)
        total[part] = COULOMB * (charges / distances * numpy.exp(-distances / options.screening)).sum(axis=1)
    return total


outside = Connectivity(Input=ours, ExtractionMode="Extract Largest Region")
largest = servermanager.Fetch(Clean(Input=outside, PointMerging=0))  # without the points of what is inside
values = potential(vtk_to_numpy(largest.GetPoints().GetData()).astype(float))
function = producer(largest, "Potential", values)
start = time.perf_counter()
approximation = MeshlessApproximation(Input=function, ScalarArray=["POINTS", "Potential"], SampleFraction=options.centers,
                                      PersistenceThreshold=options.persistence, ResultArrayName="Approximation",
                                      Kernel="ThinPlate")  # for Cubic, points of iso-surfaces come too close to each other
approximation.UpdatePipeline()
print(f"\npotential from {values.min():.4f} to {values.max():.4f} V; MeshlessApproximation: {time.perf_counter() - start:.1f} s")
fields = servermanager.Fetch(approximation, idx=0).GetFieldData()
for name in "CentreCount", "StarCount", "Missing", "LInfinityError", "MeanError", "ScalarBytes", "ModelBytes":
    print(f"{name}: {fields.GetArray(name).GetTuple1(0):.6g}")
for name in "Potential", "Approximation":
    for persistence in 0, options.persistence:
        critical = MeshCriticalPoints(Input=OutputPort(approximation, 0), ScalarArray=["POINTS", name],
                                      PersistenceThreshold=persistence)
        counts = servermanager.Fetch(critical, idx=0).GetFieldData().GetArray("CriticalCounts")
        print(f"{name}, persistence {persistence}: {vtk_to_numpy(counts).ravel()} minima, saddles, maxima")
morse = MorseComplex(Input=OutputPort(approximation, 0), ScalarArray=["POINTS", "Approximation"],
                     PersistenceThreshold=options.persistence)

# The picture.
reaches = radii[:, None]
middle, size = atoms.mean(axis=0), numpy.linalg.norm((atoms + reaches).max(axis=0) - (atoms - reaches).min(axis=0))
axes = numpy.linalg.eigh(numpy.cov(atoms.T))[1]  # the molecule's longest extent points up, the shortest to the viewer
towards, up = axes[:, 0], axes[:, 2]


def make_view():
    view = CreateRenderView()
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.CameraFocalPoint = middle
    view.CameraPosition = middle + 3 * size * towards
    view.CameraViewUp = up
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.5 * size / options.zoom
    return view


def mark(source, view, color, lift):
    """Shows something in one color, a little nearer than the surface; a parallel projection does not show the difference."""
    shown = Show(source, view)
    shown.ColorArrayName = [None, ""]
    shown.Position = lift * size * towards
    shown.AmbientColor = shown.DiffuseColor = color
    shown.Ambient = 0.3


def select(source, array, kind):
    return Threshold(Input=source, Scalars=array, LowerThreshold=kind - 0.5, UpperThreshold=kind + 0.5)


views = [make_view() for _ in range(3)]
centers = polydata(atoms)
producer(centers, "Charge", charges)
balls = Glyph(Input=producer(centers, "Radius", radii), GlyphType="Sphere", GlyphMode="All Points", ScaleFactor=2,
              ScaleArray=["POINTS", "Radius"], OrientationArray=["POINTS", "No orientation array"])
shown = Show(balls, views[0])
ColorBy(shown, ("POINTS", "Charge"))
colors = GetColorTransferFunction("Charge")
colors.ApplyPreset("Cool to Warm", True)
colors.RescaleTransferFunction(-1, 1)
extent = numpy.quantile(abs(values), 0.999)
for view in views[1:]:
    shown = Show(GenerateSurfaceNormals(Input=function, FeatureAngle=180), view)
    ColorBy(shown, ("POINTS", "Potential"))
    colors = GetColorTransferFunction("Potential")
    colors.ApplyPreset("Cool to Warm", True)
    colors.RescaleTransferFunction(-extent, extent)
bar = GetScalarBar(colors, views[2])
bar.Title, bar.ComponentTitle = "potential, V", ""
bar.Orientation, bar.WindowLocation, bar.Position = "Horizontal", "Any Location", [0.3, 0.01]
bar.ScalarBarLength, bar.ScalarBarThickness = 0.4, 12
bar.TitleFontSize = bar.LabelFontSize = 16
bar.TitleColor = bar.LabelColor = [0, 0, 0]
bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.2g", "%.2g"
shown.SetScalarBarVisibility(views[2], True)
levels = Contour(Input=function, ContourBy=["POINTS", "Potential"], Isosurfaces=list(numpy.linspace(-extent, extent, 25)))
mark(Tube(Input=levels, Radius=0.0007 * size), views[1], [0.2, 0.2, 0.2], 0.001)
for kind, color in [(0, [0.1, 0.3, 0.8]), (1, [0.8, 0.2, 0.1])]:
    lines = select(OutputPort(morse, 0), ["CELLS", "SeparatrixType"], kind)
    mark(Tube(Input=ExtractSurface(Input=lines), Radius=0.002 * size), views[2], color, 0.005)
types = vtk_to_numpy(servermanager.Fetch(morse, idx=1).GetPointData().GetArray("CriticalType"))
for kind, color in [(0, [0.1, 0.2, 0.9]), (1, [0.1, 0.7, 0.2]), (3, [0.9, 0.1, 0.1])]:
    if (types == kind).any():
        points = select(OutputPort(morse, 1), ["POINTS", "CriticalType"], kind)
        mark(Glyph(Input=points, GlyphType="Sphere", GlyphMode="All Points", ScaleArray=["POINTS", "No scale array"],
                   OrientationArray=["POINTS", "No orientation array"], ScaleFactor=0.016 * size), views[2], color, 0.01)

layout = CreateLayout("molecule")
layout.SplitHorizontal(0, 0.333)
layout.SplitHorizontal(2, 0.5)
for view, cell in zip(views, (1, 5, 6)):
    AssignViewToLayout(view, layout, cell)
layout.SetSize(1800, 800)
SaveScreenshot(options.picture, layout, ImageResolution=[1800, 800])

"""Approximates a terrain of 2.9 million heights by a few thousand centers, and contours the approximation where it is needed.

usage: pvpython terrain.py PLUGIN trinidad.vtk PICTURE.png [--centers FRACTION...] [--persistence FRACTION]
                           [--values HEIGHT...] [--tolerance LENGTH] [--zoom X Y WIDTH]

PLUGIN is SurfaceScalars.so; Utilities/fetch-data.sh fetches trinidad.vtk, an image of heights. MeshlessApproximation keeps
the peaks, pits and passes above a persistence, a fraction of the range of heights, and has a fraction of the points as centers
besides; MeshlessContour draws the level sets of the last approximation at some heights on the full mesh, and evaluates it
only where they are. For comparison the approximation is evaluated at all points and contoured linearly. Left: the terrain with
the level sets; right: a part of it, with the level sets of the heights themselves in gray.
"""

import argparse
import time

import numpy
from paraview.simple import *
from vtk.util.numpy_support import vtk_to_numpy

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("plugin")
parser.add_argument("terrain")
parser.add_argument("picture")
parser.add_argument("--centers", nargs="+", type=float, default=[0.0003, 0.001])
parser.add_argument("--persistence", type=float, default=0.1)
parser.add_argument("--values", nargs="+", type=float, default=[2200, 2800, 3400])
parser.add_argument("--tolerance", type=float, default=10)
parser.add_argument("--zoom", nargs=3, type=float, default=[500, -13000, 24000])
options = parser.parse_args()
LoadPlugin(options.plugin, remote=False, ns=globals())  # from now on its filters are functions


def seconds(source):
    """Of processor time, of all threads together."""
    start = time.process_time()
    source.UpdatePipeline()
    return time.process_time() - start


def figure(source, name):
    return source.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetArray(name).GetTuple1(0)


terrain = LegacyVTKReader(FileNames=[options.terrain])
print(f"read in {seconds(terrain):.1f} s: {terrain.GetDataInformation().GetNumberOfPoints()} heights from "
      "{:.0f} to {:.0f} m".format(*terrain.PointData["Elevation"].GetRange()))
print("centers  of stars  missing  largest error  mean error, m   model's bytes  heights' bytes  seconds")
for fraction in options.centers:
    approximation = MeshlessApproximation(
        Input=terrain, ScalarArray=["POINTS", "Elevation"], SampleFraction=fraction, Kernel="Linear",  # rough as terrain is
        PersistenceThreshold=options.persistence, ResultArrayName="Approximation")
    duration = seconds(approximation)
    numbers = [figure(approximation, name) for name in
               ("CentreCount", "StarCount", "Missing", "LInfinityError", "MeanError", "ModelBytes", "ScalarBytes")]
    print("{:7.0f} {:9.0f} {:8.0f} {:14.1f} {:14.2f} {:15.0f} {:15.0f}".format(*numbers), f"{duration:8.1f}", flush=True)

model = OutputPort(approximation, 1)
mesh = Triangulate(Input=ExtractSurface(Input=terrain))
mesh.UpdatePipeline()
print(f"\n{mesh.GetDataInformation().GetNumberOfCells()} triangles; level sets at {options.values} m")
curves = MeshlessContour(Input=model, Surface=mesh, ContourValues=options.values, Tolerance=options.tolerance)
duration = seconds(curves)
counts = curves.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetArray("ComponentCounts")
print(f"MeshlessContour: {duration:.1f} s, {vtk_to_numpy(counts)} curves, the model evaluated "
      f"{figure(curves, 'Evaluations'):.0f} times, at {100 * figure(curves, 'EvaluatedShare'):.2f}% of the points; "
      f"largest deviation {figure(curves, 'LargestDeviation'):.2f} m")
everywhere = RBFEvaluate(Input=model, Target=mesh, ResultArrayName="Approximation")
linear = Contour(Input=everywhere, ContourBy=["POINTS", "Approximation"], Isosurfaces=options.values)
print(f"RBFEvaluate at all points: {seconds(everywhere):.1f} s, Contour: {seconds(linear):.1f} s")

# The picture, from above.
relief = ExtractSubset(Input=terrain, SampleRateI=3, SampleRateJ=3)
relief.VOI = [0, 2400, 0, 1200, 0, 0]
raised = WarpByScalar(Input=ExtractSurface(Input=relief), Scalars=["POINTS", "Elevation"], ScaleFactor=2)
surface = GenerateSurfaceNormals(Input=raised, FeatureAngle=180)
heights = Contour(Input=terrain, ContourBy=["POINTS", "Elevation"], Isosurfaces=options.values)
left, right, top, bottom = terrain.GetDataInformation().GetBounds()[:4]
places = [(left + right) / 2, (top + bottom) / 2, right - left], options.zoom
layout = CreateLayout("terrain")
layout.SplitHorizontal(0, 0.6)
for cell, (x, y, width), aspect in zip((1, 2), places, (1080 / 680, 720 / 680)):
    view = CreateRenderView()
    AssignViewToLayout(view, layout, cell)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    shown = Show(surface, view)
    ColorBy(shown, ("POINTS", "Elevation"))
    colors = GetColorTransferFunction("Elevation")
    colors.RGBPoints = [1300, 0.72, 0.80, 0.62, 2200, 0.93, 0.90, 0.74, 3000, 0.74, 0.62, 0.48, 4300, 1, 1, 1]
    for source, color, thickness in [(heights, [0.3, 0.3, 0.3], 1), (curves, [0.7, 0.05, 0.05], 2)]:
        if cell == 2 or source is curves:
            drawn = Show(source, view)
            drawn.ColorArrayName = [None, ""]
            drawn.AmbientColor = drawn.DiffuseColor = color
            drawn.Ambient, drawn.Diffuse = 1, 0
            drawn.LineWidth = thickness
            drawn.Position = [0, 0, 10000]  # above the terrain
    Render(view)  # the first time it moves the camera
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [x, y, 0]
    view.CameraPosition = [x, y, 100000]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = 0.5 * width / aspect
layout.SetSize(1800, 680)
SaveScreenshot(options.picture, layout, ImageResolution=[1800, 680])

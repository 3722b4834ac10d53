"""Predicts the rain of 8 May 1986 at 367 places in Switzerland from 100 gauges, and draws it on the terrain.

usage: pvpython rainfall.py PLUGIN DATA_FOLDER RESULT_FOLDER

PLUGIN is SurfaceScalars.so; DATA_FOLDER holds sic97_*.vtk (Utilities/fetch-data.sh). Writes rainfall.vtp, the model, and
rainfall.png, and prints how well the held-out gauges are predicted.

The kernel is chosen from the 100 gauges alone: each is predicted from the 99 others. Kernels whose error is within one
standard error of the smallest are equally good as far as 100 gauges can tell, and the simplest of them is taken: one
without a width before one whose width must be fitted.
"""

import os
import sys

import numpy
from paraview.simple import *
from vtk.util.numpy_support import vtk_to_numpy

if len(sys.argv) != 4:
    sys.exit(__doc__)
plugin, data, results = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())  # from now on its filters are functions

observed = LegacyVTKReader(FileNames=[os.path.join(data, "sic97_observed.vtk")])
held_out = LegacyVTKReader(FileNames=[os.path.join(data, "sic97_held_out.vtk")])
elevation = LegacyVTKReader(FileNames=[os.path.join(data, "sic97_dem.vtk")])


def array(proxy, name, port=0):
    return vtk_to_numpy(servermanager.Fetch(proxy, idx=port).GetPointData().GetArray(name))


def positions(proxy):
    return vtk_to_numpy(servermanager.Fetch(proxy).GetPoints().GetData())[:, :2]


def predict(target, **properties):
    return RBFExtend(Input=observed, ScalarArray=["POINTS", "Rainfall"], Target=target, Scheme="GlobalRBF",
                     ResultArrayName="Predicted", ClampToRange=1, **properties)


def root_mean_square(errors):
    return numpy.sqrt(numpy.mean(errors ** 2))


# The kernel, from the observed gauges.
kernels = ["Linear", "ThinPlate", "Cubic", "Exponential", "Multiquadric", "InverseMultiquadric", "Gaussian", "Wendland", "Wu"]
without_width = {"Linear", "ThinPlate", "Cubic"}
left_out = {}
for kernel in kernels:
    filter = predict(held_out, Kernel=kernel, ComputeLeaveOneOutErrors=1)
    filter.UpdatePipeline()
    left_out[kernel] = array(filter, "LeaveOneOutError", port=1)
best = min(kernels, key=lambda kernel: root_mean_square(left_out[kernel]))
squares = left_out[best] ** 2
limit = numpy.sqrt(squares.mean() + squares.std() / numpy.sqrt(len(squares)))
good = [kernel for kernel in kernels if root_mean_square(left_out[kernel]) <= limit]
chosen = min(good, key=lambda kernel: (kernel not in without_width, root_mean_square(left_out[kernel])))

print("kernel                left-one-out  held out   (root mean square, 1/10 mm)")
rain = array(held_out, "Rainfall")
predictions = {}
for kernel in kernels:
    predictions[kernel] = array(predict(held_out, Kernel=kernel), "Predicted")
    mark = "<- chosen" if kernel == chosen else ""
    print(f"{kernel:20} {root_mean_square(left_out[kernel]):12.1f} "
          f"{root_mean_square(predictions[kernel] - rain):10.1f}  {mark}")

# What others do, for comparison.
gauges, measured = positions(observed), array(observed, "Rainfall")
distances = numpy.linalg.norm(positions(held_out)[:, None] - gauges[None], axis=2)
weights = 1.0 / distances ** 2
rows = [("nearest gauge (Voronoi)", measured[distances.argmin(axis=1)]),
        ("inverse squared distance", (weights @ measured) / weights.sum(axis=1)),
        (f"GlobalRBF, {chosen}", predictions[chosen])]
print("\nheld-out gauges           root mean square  mean absolute  largest  of largest rain  lowest prediction")
for name, prediction in rows:
    errors = prediction - rain
    print(f"{name:25} {root_mean_square(errors):16.1f} {abs(errors).mean():14.1f} {abs(errors).max():8.0f} "
          f"{abs(errors).max() / rain.max():15.2f} {prediction.min():18.0f}")

# The map.
terrain = predict(elevation, Kernel=chosen)
terrain.UpdatePipeline()
SaveData(os.path.join(results, "rainfall.vtp"), OutputPort(terrain, 1), DataMode="Binary")
relief = ExtractSurface(Input=WarpByScalar(Input=terrain, Scalars=["POINTS", "Elevation"], ScaleFactor=3))
surface = GenerateSurfaceNormals(Input=relief)
lines = Contour(Input=surface, ContourBy=["POINTS", "Predicted"], Isosurfaces=[50 * i for i in range(1, 12)])
stations = Glyph(Input=observed, GlyphType="Sphere", GlyphMode="All Points", ScaleArray=["POINTS", "No scale array"],
                 ScaleFactor=4000)

view = CreateRenderView(ViewSize=[1400, 840])
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
shown = Show(surface, view)
ColorBy(shown, ("POINTS", "Predicted"))
shown.Ambient = 0.1
colors = GetColorTransferFunction("Predicted")
colors.ApplyPreset("Blues", True)
colors.InvertTransferFunction()
colors.RescaleTransferFunction(0, float(measured.max()))
bar = GetScalarBar(colors, view)
bar.Title, bar.ComponentTitle = "Rain, 1/10 mm", ""
bar.Orientation, bar.WindowLocation, bar.Position = "Horizontal", "Any Location", [0.3, 0.02]
bar.ScalarBarLength, bar.ScalarBarThickness = 0.4, 22
bar.TitleFontSize = bar.LabelFontSize = 22
bar.TitleColor = bar.LabelColor = [0, 0, 0]
bar.RangeLabelFormat = bar.LabelFormat = "%.0f"
bar.AutomaticLabelFormat = 0
shown.SetScalarBarVisibility(view, True)
for source, color, lift in [(lines, [0.1, 0.1, 0.25], 2500), (stations, [0.9, 0.3, 0.1], 11000)]:
    drawn = Show(source, view)
    drawn.ColorArrayName = [None, ""]
    drawn.AmbientColor = drawn.DiffuseColor = color
    drawn.LineWidth = 2
    drawn.Position = [0, 0, lift]  # above the terrain
Render(view)  # the first time it moves the camera
west, east, south, north = surface.GetDataInformation().GetBounds()[:4]
middle = [(west + east) / 2, (south + north) / 2]
view.CameraFocalPoint = [middle[0], middle[1] - 26000, 0]
view.CameraPosition = [middle[0], middle[1] - 278000, 430000]
view.CameraViewUp = [0, 0, 1]
view.CameraViewAngle = 30
SaveScreenshot(os.path.join(results, "rainfall.png"), view)

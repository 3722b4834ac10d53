"""Resamples the brightness of one scan of a statue onto another and tells how well.

usage: pvpython resample_scan.py PLUGIN lion.vtp RESULT.vtp [PICTURE.png]

PLUGIN is SurfaceScalars.so; Utilities/fetch-data.sh fetches lion.vtp. Every tenth point of the scan, in random order,
plays the first scan, with the brightness of its color as the function; all other points play the second one. Their own
brightness tells how good the prediction is.
"""

import sys

import numpy
import vtk
from paraview.simple import *
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

if len(sys.argv) < 4:
    sys.exit(__doc__)
plugin, scan, result = sys.argv[1:4]
LoadPlugin(plugin, remote=False, ns=globals())  # from now on its filters are functions

lion = servermanager.Fetch(XMLPolyDataReader(FileName=[scan]))
points = vtk_to_numpy(lion.GetPoints().GetData()).astype(float)
colors = [lion.GetPointData().GetArray(i) for i in range(lion.GetPointData().GetNumberOfArrays())]
color = next(vtk_to_numpy(array) for array in colors if array.GetNumberOfComponents() >= 3 and "ormal" not in array.GetName())
brightness = color[:, :3].astype(float) @ [0.299, 0.587, 0.114]


def cloud(chosen, **arrays):
    data = vtk.vtkPolyData()
    data.SetPoints(vtk.vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(points[chosen], deep=True))
    data.SetVerts(vtk.vtkCellArray())  # nothing is drawn without cells
    data.GetVerts().InsertNextCell(len(chosen), range(len(chosen)))
    for name, values in arrays.items():
        array = numpy_to_vtk(values[chosen], deep=True)
        array.SetName(name)
        data.GetPointData().SetScalars(array)
    source = TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


order = numpy.random.default_rng(1).permutation(len(points))
first, second = order[:len(points) // 10], order[len(points) // 10:]
known = cloud(first, Brightness=brightness)
wanted = cloud(second)

print(f"{len(first)} points with brightness, {len(second)} without; brightness varies by "
      f"{brightness[second].std():.1f} (standard deviation)")
print("scheme             root mean square  mean absolute   largest")
for scheme in ["ExplicitMLS", "ParameterizedMLS", "LocalRBF", "Hybrid"]:
    extended = RBFExtend(Input=known, ScalarArray=["POINTS", "Brightness"], Target=wanted, Scheme=scheme, ClampToRange=1)
    output = servermanager.Fetch(extended)
    errors = vtk_to_numpy(output.GetPointData().GetArray("Brightness")) - brightness[second]
    print(f"{scheme:18} {numpy.sqrt(numpy.mean(errors ** 2)):16.2f} {abs(errors).mean():14.2f} {abs(errors).max():9.1f}")
    if scheme == "ParameterizedMLS":  # averages the noise of the scanner out
        SaveData(result, extended, DataMode="Binary")
        best = extended

if len(sys.argv) > 4:
    layout = CreateLayout("side by side")
    layout.SplitHorizontal(0, 0.5)
    for cell, shown, size in [(1, known, 9), (2, best, 4)]:  # points so large that they close the gaps
        view = CreateRenderView()
        layout.AssignView(cell, view)
        view.OrientationAxesVisibility = 0
        view.UseColorPaletteForBackground = 0
        view.Background = [1, 1, 1]
        drawn = Show(shown, view)
        drawn.SetRepresentationType("Points")
        drawn.PointSize = size
        drawn.Ambient, drawn.Diffuse = 1, 0
        ColorBy(drawn, ("POINTS", "Brightness"))
        Render(view)
        view.CameraFocalPoint = [0, 0, 0]
        view.CameraPosition = [1.4, -2.6, 0.9]  # from the front
        view.CameraViewUp = [0, 0, 1]
        ResetCamera(view)
        view.GetActiveCamera().Dolly(1.5)
    colors = GetColorTransferFunction("Brightness")
    colors.ApplyPreset("Grayscale", True)
    colors.RescaleTransferFunction(0, 255)
    layout.SetSize(1400, 900)
    SaveScreenshot(sys.argv[4], layout, ImageResolution=[1400, 900])

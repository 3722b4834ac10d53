"""Draws four functions that know nothing but the points of a scan, with their contours.

usage: pvpython surface_functions.py PLUGIN kitten.xyz PICTURE.png

PLUGIN is SurfaceScalars.so; kitten.xyz lies in Data. From left to right: the geodesic distance from the tip of an ear, the
harmonic function that is 1 there and 0 at the point farthest from it, the third eigenfunction of the Laplacian, and heat that
began at the ear and had some time to spread.
"""

import sys

import numpy
from paraview.simple import *
from vtk.util.numpy_support import vtk_to_numpy

if len(sys.argv) != 4:
    sys.exit(__doc__)
plugin, scan, picture = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())  # from now on its filters are functions

table = CSVReader(FileName=[scan], HaveHeaders=0, FieldDelimiterCharacters=" ")
points = TableToPoints(Input=table, XColumn="Field 0", YColumn="Field 1", ZColumn="Field 2")
places = vtk_to_numpy(servermanager.Fetch(points).GetPoints().GetData())
ear = int(places[:, 1].argmin())  # y points downwards
farthest = int(numpy.linalg.norm(places - places[ear], axis=1).argmax())
functions = {
    "Geodesic": {"SourceIds": [ear]},
    "Harmonic": {"ConstraintIds": [ear, farthest], "ConstraintValues": [1, 0]},
    "LaplacianEigenfunction": {"EigenIndex": 3},
    "Diffusion": {"SourceIds": [ear], "DiffusionTime": 0.04}}

towards = numpy.array([-1, -0.4, 1]) / numpy.sqrt(2.16)  # the viewer
layout = CreateLayout("functions")
for cell in 0, 1, 2:
    layout.SplitHorizontal(cell, 0.5)
layout.SetSize(2000, 800)
for (name, properties), cell in zip(functions.items(), (3, 4, 5, 6)):
    function = PointSetScalarFunction(Input=points, Function=name, **properties)
    values = vtk_to_numpy(servermanager.Fetch(function).GetPointData().GetArray(name))
    print(f"{name}: {values.min():.4g} to {values.max():.4g}")
    # Values that part the points evenly: harmonic functions are steep at single points.
    contours = PointSetContour(Input=function, ScalarArray=["POINTS", name],
                               ContourValues=list(numpy.quantile(values, numpy.linspace(0, 1, 15)[1:-1])))
    view = CreateRenderView()
    AssignViewToLayout(view, layout, cell)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    discs = Show(function, view)
    discs.SetRepresentationType("Point Gaussian")
    discs.GaussianRadius = 0.012
    discs.ShaderPreset = "Plain circle"
    ColorBy(discs, ("POINTS", name))
    colors = GetColorTransferFunction(name)
    colors.ApplyPreset("Viridis (matplotlib)", True)
    colors.RescaleTransferFunction(*numpy.quantile(values, [0.01, 0.99]))
    curves = Show(Tube(Input=contours, Radius=0.002), view)
    curves.ColorArrayName = [None, ""]
    curves.AmbientColor = curves.DiffuseColor = [0.1, 0.1, 0.1]
    curves.Position = 0.04 * towards  # in front of the discs; a parallel projection does not show the difference
for view in GetRenderViews():
    Render(view)  # first, since it places the camera by itself
    view.CameraFocalPoint = [-0.04, -0.05, -0.04]
    view.CameraPosition = view.CameraFocalPoint + 5 * towards
    view.CameraViewUp = [0, -1, 0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.62
SaveScreenshot(picture, layout, ImageResolution=[2000, 800])

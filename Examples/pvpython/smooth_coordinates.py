"""Smooths the three coordinates of a mesh, as functions on it, and draws the surface that they make.

usage: pvpython smooth_coordinates.py PLUGIN MESH PICTURE.png [EPSILON]

PLUGIN is SurfaceScalars.so; MESH is anything that ParaView opens as triangles. From left to right: the mesh, its coordinates
smoothed by Tikhonov regularization, and smoothed with all critical points of each coordinate and their neighbors as
interpolating constraints (the smoothing paper's Fig. 17).
"""

import sys

import numpy
from paraview.simple import *

if len(sys.argv) not in (4, 5):
    sys.exit(__doc__)
plugin, path, picture = sys.argv[1:4]
epsilon = float(sys.argv[4]) if len(sys.argv) == 5 else 1e6
LoadPlugin(plugin, remote=False, ns=globals())  # from now on its filters are functions

mesh = OpenDataFile(path)
mesh.UpdatePipeline()


def smoothCoordinates(**properties):
    result = mesh
    for axis, direction in zip("XYZ", numpy.eye(3)):
        result = PointSetScalarFunction(Input=result, Function="Height", Direction=direction, ResultArrayName=axis)
        result = ConstrainedSmoothing(Input=result, ScalarArray=["POINTS", axis], ResultArrayName="Smooth" + axis, **properties)
        result = OutputPort(result, 0)
    return ProgrammableFilter(Input=result, Script="""
import numpy
from vtkmodules.numpy_interface import algorithms
arrays = [inputs[0].PointData["Smooth" + axis] for axis in "XYZ"]
output.Points = algorithms.make_vector(*arrays)
""")


surfaces = [
    mesh,
    smoothCoordinates(Method="Tikhonov", EpsilonChoice="Manual", Epsilon=epsilon),
    smoothCoordinates(Method="InterpolatingConstraints", Constraints="AllCriticalPoints", SmoothedStars=0)]
bounds = numpy.reshape(mesh.GetDataInformation().GetBounds(), (3, 2))
boxDiagonal = numpy.linalg.norm(numpy.diff(bounds))
layout = CreateLayout("coordinates")
layout.SplitHorizontal(0, 0.33)
layout.SplitHorizontal(2, 0.5)
layout.SetSize(1800, 700)
for surface, cell in zip(surfaces, (1, 5, 6)):
    view = CreateRenderView()
    AssignViewToLayout(view, layout, cell)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    shown = Show(surface, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.AmbientColor = shown.DiffuseColor = [0.75, 0.78, 0.85]
    shown.Interpolation = "Flat"
    view.CameraFocalPoint = bounds.mean(axis=1)
    view.CameraPosition = bounds.mean(axis=1) + 3 * boxDiagonal * numpy.array([0.3, 0.2, 1])
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.4 * boxDiagonal
SaveScreenshot(picture, layout, ImageResolution=[1800, 700])

"""Draws the osculating paraboloid of a function at a saddle of a scan, with the contour that crosses itself there.

usage: pvpython osculating_paraboloid.py PLUGIN kitten.xyz PICTURE.png

PLUGIN is SurfaceScalars.so; kitten.xyz lies in Data. f is the distance from the point (0, 0, 0). A saddle is a sample
where the gradient of f along the surface almost vanishes and the Hessian has eigenvalues of both signs.
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
distance = PointSetScalarFunction(Input=points, Function="DistanceToPoint", Center=[0, 0, 0])
name = distance.ResultArrayName or "DistanceToPoint"

# Derivatives of f at the samples themselves. Those of ParameterizedMLS lie in the tangent plane.
derived = servermanager.Fetch(RBFExtend(
    Input=distance, ScalarArray=["POINTS", name], Target=points, Scheme="ParameterizedMLS", ResultArrayName="F",
    ComputeGradient=1, ComputeHessian=1))
gradients = vtk_to_numpy(derived.GetPointData().GetArray("FGradient"))
xx, yy, zz, xy, yz, xz = vtk_to_numpy(derived.GetPointData().GetArray("FHessian")).T
hessians = numpy.stack([numpy.stack(row, -1) for row in ([xx, xy, xz], [xy, yy, yz], [xz, yz, zz])], 1)
eigenvalues = numpy.linalg.eigvalsh(hessians)  # ascending; that along the normal is 0
low, high = eigenvalues[:, 0], eigenvalues[:, 2]
curved = numpy.minimum(-low, high)
candidates = numpy.flatnonzero(curved > numpy.quantile(curved, 0.5))
# The Newton step to the critical point, as far as the gradient and the weaker curvature tell.
steps = numpy.linalg.norm(gradients[candidates], axis=1) / curved[candidates]
saddle = int(candidates[steps.argmin()])
value = vtk_to_numpy(derived.GetPointData().GetArray("F"))[saddle]
place = derived.GetPoint(saddle)
print(f"saddle at point {saddle}, {tuple(round(c, 3) for c in place)}: f = {value:.4f}, "
      f"gradient {numpy.linalg.norm(gradients[saddle]):.4f}, curvatures {low[saddle]:.3f} and {high[saddle]:.3f}")

paraboloid = OsculatingParaboloid(Input=distance, ScalarArray=["POINTS", name], PointId=saddle)
contour = PointSetContour(Input=distance, ScalarArray=["POINTS", name], ContourValues=[value])
view = CreateRenderView(ViewSize=[1400, 1000])
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
cloud = Show(points, view)
cloud.SetRepresentationType("Points")
cloud.PointSize = 3
cloud.AmbientColor = cloud.DiffuseColor = [0.65, 0.65, 0.65]
cloud.ColorArrayName = ["POINTS", ""]
yellow = Show(paraboloid, view)
yellow.ColorArrayName = ["POINTS", ""]
yellow.DiffuseColor = [0.95, 0.8, 0.2]
yellow.Opacity = 0.85
curve = Show(contour, view)
curve.ColorArrayName = ["POINTS", ""]
curve.AmbientColor = curve.DiffuseColor = [0.1, 0.2, 0.6]
curve.LineWidth = 4
view.CameraFocalPoint = place
view.CameraPosition = [place[0] + 0.25, place[1] + 0.35, place[2] + 0.5]
view.CameraViewUp = [0, 1, 0]
Render(view)
SaveScreenshot(picture, view)

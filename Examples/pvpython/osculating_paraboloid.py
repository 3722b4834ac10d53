"""Draws the osculating paraboloid of a function at a saddle of a scan, with the contour that nearly crosses itself there.

usage: pvpython osculating_paraboloid.py PLUGIN kitten.xyz PICTURE.png

PLUGIN is SurfaceScalars.so; kitten.xyz lies in Data. f is the distance from the point (0, 0, 0). A saddle is a sample
where the gradient of f along the surface almost vanishes and the Hessian has eigenvalues of both signs. Among those that
are neither sharply curved nor nearly flat the one nearest to a critical point is drawn.
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
weaker, stronger = numpy.minimum(-low, high), numpy.maximum(-low, high)
candidates = numpy.flatnonzero((weaker > numpy.quantile(weaker, 0.5)) & (stronger < numpy.quantile(stronger, 0.9)))
# The Newton step to the critical point, as far as the gradient and the weaker curvature tell.
steps = numpy.linalg.norm(gradients[candidates], axis=1) / weaker[candidates]
saddle = int(candidates[steps.argmin()])
value = vtk_to_numpy(derived.GetPointData().GetArray("F"))[saddle]
place = derived.GetPoint(saddle)
print(f"saddle at point {saddle}, {tuple(round(c, 3) for c in place)}: f = {value:.4f}, "
      f"gradient {numpy.linalg.norm(gradients[saddle]):.4f}, curvatures {low[saddle]:.3f} and {high[saddle]:.3f}")

# So many neighbors that it reaches eight sampling steps.
paraboloid = OsculatingParaboloid(Input=distance, ScalarArray=["POINTS", name], PointId=saddle, NeighborCount=200)
crossing = PointSetContour(Input=distance, ScalarArray=["POINTS", name], ContourValues=[value])
others = PointSetContour(Input=distance, ScalarArray=["POINTS", name],
                         ContourValues=[value + 0.01 * i for i in range(-6, 7) if i != 0])


def balls(source, radius):
    return Glyph(Input=source, GlyphType="Sphere", GlyphMode="All Points", ScaleArray=["POINTS", "No scale array"],
                 OrientationArray=["POINTS", "No orientation array"], ScaleFactor=2 * radius)


# What hides the far side: pale balls just below the points, along the normals that the file brings.
inward = Calculator(Input=points, Function='-("Field 3"*iHat + "Field 4"*jHat + "Field 5"*kHat)', ResultArrayName="Inward")
below = balls(WarpByVector(Input=inward, Vectors=["POINTS", "Inward"], ScaleFactor=0.023), 0.02)
view = CreateRenderView(ViewSize=[1400, 1000])
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
for source, color in [(below, [0.95, 0.95, 0.93]), (balls(points, 0.002), [0.6, 0.6, 0.6]),
                      (paraboloid, [1, 0.8, 0.2]), (Tube(Input=others, Radius=0.001), [0.3, 0.5, 0.8]),
                      (Tube(Input=crossing, Radius=0.003), [0.1, 0.15, 0.5])]:
    drawn = Show(source, view)
    drawn.ColorArrayName = ["POINTS", ""]
    drawn.AmbientColor = drawn.DiffuseColor = color
    drawn.Ambient = 0.2
Render(view)  # the first time it moves the camera
view.CameraFocalPoint = place
view.CameraPosition = [place[0] + 0.4, place[1] + 0.3, place[2] + 0.8]
view.CameraViewUp = [0, 1, 0]
view.CameraViewAngle = 30
SaveScreenshot(picture, view)

"""Critical points of a function of space on a coarse mesh: at its vertices, and off them.

usage: pvpython model_critical_points.py PLUGIN PICTURE.png

PLUGIN is SurfaceScalars.so. A sum of radial functions through 150 values is classified on a torus of 1152 vertices, by its
values there (left) and as the model that it is (right). Level sets are those of the function on a fine torus. Minima blue,
saddles green, maxima red. Prints how many points there are, how many Newton steps led to them, and how far they are from
those that a mesh 16 times as fine has.
"""

import argparse

import numpy
from paraview.simple import *
from vtk.util.numpy_support import vtk_to_numpy

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("plugin")
parser.add_argument("picture")
options = parser.parse_args()
LoadPlugin(options.plugin, remote=False, ns=globals())  # from now on its filters are functions

COLORS = {0: [0.1, 0.3, 0.9], 1: [0.1, 0.6, 0.1], 3: [0.85, 0.1, 0.1]}


def torus(resolution):
    """R = 0.7, r = 0.3, around the y axis."""
    shape = Superquadric(Toroidal=1, Thickness=0.43, Size=1, ThetaResolution=2 * resolution, PhiResolution=resolution,
                         ThetaRoundness=1, PhiRoundness=1, Scale=[1, 1, 1])
    return Clean(Input=Triangulate(Input=shape))


def arrayOf(source, port, name):
    return vtk_to_numpy(servermanager.Fetch(source, idx=port).GetPointData().GetArray(name))


def placesOf(source):
    return vtk_to_numpy(servermanager.Fetch(source, idx=1).GetPoints().GetData())


def draw(view, mesh, levels, critical):
    surface = Show(mesh, view)
    surface.SetRepresentationType("Surface With Edges")
    surface.DiffuseColor = surface.AmbientColor = [0.93, 0.93, 0.9]
    surface.EdgeColor = [0.75, 0.75, 0.72]
    lines = Show(levels, view)
    lines.ColorArrayName = [None, ""]
    lines.DiffuseColor = lines.AmbientColor = [0.35, 0.35, 0.35]
    for kind, color in COLORS.items():
        chosen = Threshold(Input=OutputPort(critical, 1), Scalars=["POINTS", "CriticalType"],
                           LowerThreshold=kind - 0.5, UpperThreshold=kind + 0.5)
        spheres = Glyph(Input=chosen, GlyphType="Sphere", GlyphMode="All Points", ScaleFactor=0.05,
                        ScaleArray=["POINTS", "No scale array"])
        spheres.GlyphType.ThetaResolution = spheres.GlyphType.PhiResolution = 24
        balls = Show(spheres, view)
        balls.ColorArrayName = [None, ""]
        balls.DiffuseColor = balls.AmbientColor = color
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.1, 2.6, 1.9], [0, 0, 0], [0, 1, 0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 1.02
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]


samples = MaskPoints(Input=Clean(Input=torus(60)), MaximumNumberofPoints=150, RandomSampling=1, OnRatio=1,
                     RandomSamplingMode="Random Sampling")
values = Calculator(Input=samples, ResultArrayName="f",
                    Function="sin(4*coordsX+0.7)*cos(3.4*coordsZ-0.4)+0.6*coordsY")
coarse, fine = torus(24), torus(96)
model = OutputPort(RBFExtend(Input=values, Target=coarse, Scheme="GlobalRBF", ScalarArray=["POINTS", "f"]), 1)

atVertices = MeshCriticalPoints(Input=RBFEvaluate(Input=model, Target=coarse), ScalarArray=["POINTS", "f"])
refined = MeshCriticalPoints(Input=coarse, Model=model)
onFineMesh = MeshCriticalPoints(Input=fine, Model=model)
levels = Contour(Input=RBFEvaluate(Input=model, Target=fine), ContourBy=["POINTS", "f"],
                 Isosurfaces=[float(x) for x in numpy.linspace(-1.5, 1.5, 31)])

truth, found, vertices = placesOf(onFineMesh), placesOf(refined), placesOf(atVertices)
for name, places in (("vertices", vertices), ("refined", found)):
    distances = numpy.linalg.norm(places[:, None] - truth[None], axis=2)
    print(f"{name}: {len(places)} points for {len(truth)}, each of these within {distances.min(axis=0).max():.4f}")
print(f"Newton steps: {arrayOf(refined, 1, 'Iterations').tolist()}")

layout = CreateLayout("critical points")
views = [CreateRenderView(), CreateRenderView()]
AssignViewToLayout(view=views[0], layout=layout)
layout.SplitHorizontal(0, 0.5)
AssignViewToLayout(view=views[1], layout=layout, hint=2)
layout.SetSize(1600, 800)
for view, critical in zip(views, (atVertices, refined)):
    draw(view, coarse, levels, critical)
SaveScreenshot(options.picture, layout, ImageResolution=[1600, 800])

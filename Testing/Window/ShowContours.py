"""Runs inside ParaView's window: contours the scan that ships, the filter selected so that its panel shows."""

import os

import numpy
import vtk
from paraview import simple
from vtk.util.numpy_support import numpy_to_vtk


def show_contours():
    simple.LoadPlugin(os.environ["SURFACE_SCALARS_PLUGIN"], remote=False, ns=vars(simple))
    points = numpy.loadtxt(os.path.join(os.environ["SURFACE_SCALARS_DATA"], "kitten.xyz"))[:, :3]
    scan = vtk.vtkPolyData()
    scan.SetPoints(vtk.vtkPoints())
    scan.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    producer = simple.TrivialProducer(registrationName="kitten.xyz")
    producer.GetClientSideObject().SetOutput(scan)

    height = simple.PointSetScalarFunction(registrationName="Height", Input=producer, Direction=[0, 1, 0])
    height.UpdatePipeline()
    low, high = height.PointData["Height"].GetRange()
    contours = simple.PointSetContour(
        registrationName="Contours",
        Input=height,
        ScalarArray=["POINTS", "Height"],
        ContourValues=list(numpy.linspace(low, high, 17)[1:-1]),
    )

    view = simple.GetActiveViewOrCreate("RenderView")
    display = simple.Show(contours, view)
    simple.ColorBy(display, ("POINTS", "Height"))
    display.LineWidth = 4
    display.RenderLinesAsTubes = 1
    cloud = simple.Show(height, view)
    cloud.SetRepresentationType("Point Gaussian")
    cloud.GaussianRadius = 0.003
    cloud.AmbientColor = cloud.DiffuseColor = [0.75, 0.75, 0.75]
    simple.ColorBy(cloud, None)
    simple.SetActiveSource(contours)
    view.ResetActiveCameraToNegativeZ()
    view.GetActiveCamera().Elevation(25)
    simple.ResetCamera(view)
    simple.Render(view)


show_contours()
with open(os.environ["SURFACE_SCALARS_SHOWN"], "w", encoding="utf-8") as marker:
    marker.write("shown")

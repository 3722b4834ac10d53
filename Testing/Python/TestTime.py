"""Time series: every step is worked on on its own."""

import unittest

import numpy
import support
from paraview import simple
from vtk import vtkStreamingDemandDrivenPipeline

GROWING_SPHERE = """
import math
import random
import vtk
from vtk.util.numpy_support import numpy_to_vtk
import numpy

executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
time = 0.0
if information.Has(executive.UPDATE_TIME_STEP()):
    time = information.Get(executive.UPDATE_TIME_STEP())
generator = numpy.random.RandomState(3)
points = generator.normal(size=(3000, 3))
points *= (1.0 + time) / numpy.linalg.norm(points, axis=1)[:, None]
output = self.GetOutput()
output.SetPoints(vtk.vtkPoints())
output.GetPoints().SetData(numpy_to_vtk(points, deep=True))
height = numpy_to_vtk(numpy.ascontiguousarray(points[:, 2]), deep=True)
height.SetName('height')
output.GetPointData().SetScalars(height)
output.GetInformation().Set(output.DATA_TIME_STEP(), time)
"""

class TestTime(unittest.TestCase):
    def test_each_step_is_contoured_on_its_own(self):
        series = support.three_steps(GROWING_SPHERE)
        contour = simple.PointSetContour(Input=series, ScalarArray=["POINTS", "height"], ContourValues=[0.5])
        for time in (0.0, 1.0, 2.0, 0.0):
            contour.UpdatePipeline(time)
            contours = contour.GetClientSideObject().GetOutputDataObject(0)
            points = support.positions(contours)
            radius = numpy.linalg.norm(points, axis=1)
            self.assertEqual(list(support.field_array(contours, "ComponentCounts")), [1])
            self.assertLess(numpy.abs(radius - (1 + time)).max(), 0.01 * (1 + time))
            self.assertLess(numpy.abs(points[:, 2] - 0.5).max(), 0.01 * (1 + time))

    def test_functions_and_critical_points_follow_the_time(self):
        series = support.three_steps(GROWING_SPHERE)
        geodesic = simple.PointSetScalarFunction(Input=series, Function="Geodesic", SourceIds=[0])
        critical = simple.FuzzyCriticalPoints(Input=series, ScalarArray=["POINTS", "height"])
        for time in (0.0, 2.0, 1.0):
            radius = 1 + time
            geodesic.UpdatePipeline(time)
            distances = support.point_array(geodesic.GetClientSideObject().GetOutputDataObject(0), "Geodesic")
            self.assertAlmostEqual(distances.max() / (numpy.pi * radius), 1, delta=0.05)
            critical.UpdatePipeline(time)
            points = critical.GetClientSideObject().GetOutputDataObject(1)
            self.assertEqual(list(support.point_array(points, "CriticalType")), [0, 3])
            self.assertLess(numpy.abs(support.positions(points)[:, 2] - [-radius, radius]).max(), 0.01 * radius)

    def test_the_steps_reach_downstream(self):
        series = support.three_steps(GROWING_SPHERE)
        contour = simple.PointSetContour(Input=series)
        contour.UpdatePipelineInformation()
        information = contour.GetClientSideObject().GetOutputInformation(0)
        steps = information.Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
        self.assertEqual(list(steps), [0.0, 1.0, 2.0])


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

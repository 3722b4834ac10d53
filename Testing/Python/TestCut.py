"""Sections by implicit functions: the curves satisfy the function's equation and lie on the surface."""

import unittest

import numpy
import support
from paraview import simple


def torus_distance(points):
    axis_distance = numpy.hypot(points[:, 0], points[:, 1]) - 1
    return numpy.abs(numpy.hypot(axis_distance, points[:, 2]) - 0.4)


class TestCut(unittest.TestCase):
    def setUp(self):
        # no point array at all: a cut needs none
        self.cut = simple.PointSetContour(Input=support.source(support.polydata(support.torus_points(8000))))

    def expect_section(self, equation, count):
        contours = support.fetch(self.cut)
        self.assertEqual(list(support.field_array(contours, "ComponentCounts")), [count])
        self.assertTrue(numpy.all(support.cell_array(contours, "Closed") == 1))
        points = support.positions(contours)
        self.assertLess(numpy.abs(equation(points)).max(), 1e-7)
        self.assertLess(torus_distance(points).max(), 0.005)
        self.assertEqual(set(support.point_array(contours, "CutFunctionValue")), {0.0})

    def test_plane(self):
        self.cut.CutFunction = "Plane"
        self.cut.CutFunction.Origin = [0, 0, 0]
        self.cut.CutFunction.Normal = [1, 0, 0]
        self.cut.ContourValues = [0]
        self.expect_section(lambda p: p[:, 0], 2)  # the circles of a meridian

    def test_sphere(self):
        self.cut.CutFunction = "Sphere"
        self.cut.CutFunction.Center = [1, 0, 0]
        self.cut.CutFunction.Radius = 0.7
        self.cut.ContourValues = [0]
        self.expect_section(lambda p: numpy.linalg.norm(p - [1, 0, 0], axis=1) - 0.7, 2)

    def test_cylinder(self):
        self.cut.CutFunction = "Cylinder"
        self.cut.CutFunction.Center = [0, 0, 0]
        self.cut.CutFunction.Axis = [0, 0, 1]
        self.cut.CutFunction.Radius = 1
        self.cut.ContourValues = [0]
        self.expect_section(lambda p: numpy.hypot(p[:, 0], p[:, 1]) - 1, 2)  # the highest and the lowest circle

    def test_box(self):
        self.cut.CutFunction = "Box"
        self.cut.CutFunction.Position = [-2, -2, 0.1]
        self.cut.CutFunction.Length = [4, 4, 2]
        self.cut.ContourValues = [0]
        self.expect_section(lambda p: p[:, 2] - 0.1, 2)

    def test_parallel_sections_in_one_pass(self):
        self.cut.CutFunction = "Plane"
        self.cut.CutFunction.Origin = [0, 0, 0]
        self.cut.CutFunction.Normal = [0, 0, 1]
        self.cut.ContourValues = [-0.2, 0, 0.2, 0.9]
        contours = support.fetch(self.cut)
        self.assertEqual(list(support.field_array(contours, "ComponentCounts")), [2, 2, 2, 0])
        values = support.point_array(contours, "CutFunctionValue")
        self.assertLess(numpy.abs(support.positions(contours)[:, 2] - values).max(), 1e-7)

    def test_moving_the_function_moves_the_section(self):
        self.cut.CutFunction = "Plane"
        self.cut.CutFunction.Normal = [0, 0, 1]
        self.cut.ContourValues = [0]
        for height in (0.0, 0.25):
            self.cut.CutFunction.Origin = [0, 0, height]
            points = support.positions(support.fetch(self.cut))
            self.assertLess(numpy.abs(points[:, 2] - height).max(), 1e-7)

    def test_none_returns_to_the_array(self):
        points = support.torus_points(4000)
        contour = simple.PointSetContour(
            Input=support.source(support.polydata(points, f=points[:, 2])), ContourValues=[0.1]
        )
        contour.CutFunction = "Plane"
        self.assertIsNone(support.fetch(contour).GetPointData().GetArray("f"))
        contour.CutFunction = "None"
        self.assertIsNotNone(support.fetch(contour).GetPointData().GetArray("f"))


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

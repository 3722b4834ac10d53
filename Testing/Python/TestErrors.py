"""What goes wrong is said in one sentence that names the filter, what was expected and what was found; outputs stay empty."""

import unittest

import numpy
import support
from paraview import simple


class TestErrors(unittest.TestCase):
    def contour(self, dataset, **properties):
        """Contours and everything that was said on the way."""
        with support.Messages() as messages:
            contour = simple.PointSetContour(Input=support.source(dataset), **properties)
            contours = support.fetch(contour)
            samples = support.fetch(contour, 1)
        return contours, samples, messages.text

    def expect_refused(self, dataset, *words, **properties):
        contours, samples, text = self.contour(dataset, **properties)
        self.assertEqual(contours.GetNumberOfPoints(), 0)
        self.assertEqual(samples.GetNumberOfPoints(), 0)
        self.assertIn("Point Set Contour: ", text)
        for word in words:
            self.assertIn(word, text)

    def test_no_points(self):
        self.expect_refused(support.polydata(numpy.zeros((0, 3)), f=numpy.zeros(0)), "found none", ContourValues=[0])

    def test_too_few_points(self):
        points = support.torus_points(3)
        self.expect_refused(support.polydata(points, f=points[:, 2]), "found 3", ContourValues=[0])

    def test_no_array(self):
        self.expect_refused(support.polydata(support.torus_points(500)), "array", ContourValues=[0])

    def test_an_array_that_is_not_there(self):
        points = support.torus_points(500)
        dataset = support.polydata(points, f=points[:, 2])
        self.expect_refused(dataset, "missing", ContourValues=[0], ScalarArray=["POINTS", "missing"])

    def test_a_vector(self):
        points = support.torus_points(500)
        dataset = support.polydata(points, velocity=points)
        self.expect_refused(dataset, "velocity", "3", ContourValues=[0], ScalarArray=["POINTS", "velocity"])

    def test_all_points_equal(self):
        self.expect_refused(support.polydata(numpy.ones((50, 3)), f=numpy.arange(50.0)), "50", ContourValues=[3])

    def test_only_missing_values(self):
        dataset = support.polydata(support.torus_points(50), f=numpy.full(50, numpy.nan))
        self.expect_refused(dataset, "50", ContourValues=[0])

    def test_missing_values_are_left_out_with_one_warning(self):
        points = support.torus_points(4000)
        values = points[:, 2].copy()
        values[:7] = numpy.nan
        values[7] = numpy.inf
        contours, _, text = self.contour(support.polydata(points, f=values), ContourValues=[0.1])
        self.assertEqual(list(support.field_array(contours, "ComponentCounts")), [2])
        self.assertEqual(text.lower().count("warning"), 1)
        self.assertIn("8", text)

    def test_after_an_error_is_corrected_the_filter_works(self):
        points = support.torus_points(4000)
        dataset = support.polydata(points, f=points[:, 2], velocity=points)
        contour = simple.PointSetContour(Input=support.source(dataset), ContourValues=[0.1])
        with support.Messages():
            contour.ScalarArray = ["POINTS", "velocity"]
            self.assertEqual(support.fetch(contour).GetNumberOfPoints(), 0)
        contour.ScalarArray = ["POINTS", "f"]
        self.assertGreater(support.fetch(contour).GetNumberOfPoints(), 0)

    def test_function_without_points_or_direction(self):
        with support.Messages() as messages:
            function = simple.PointSetScalarFunction(
                Input=support.source(support.polydata(support.torus_points(10))), Direction=[0, 0, 0]
            )
            support.fetch(function)
        self.assertIn("Point Set Scalar Function: ", messages.text)

    def expect_function_refused(self, *words, **properties):
        with support.Messages() as messages:
            function = simple.PointSetScalarFunction(
                Input=support.source(support.polydata(support.torus_points(500))), **properties
            )
            self.assertEqual(support.fetch(function).GetNumberOfPoints(), 0)
        self.assertIn("Point Set Scalar Function: needs ", messages.text)
        for word in words:
            self.assertIn(word, messages.text)

    def test_functions_without_sources(self):
        self.expect_function_refused("SourceIds", "found none", Function="Geodesic")
        self.expect_function_refused("SourceIds", "found none", Function="Diffusion")
        self.expect_function_refused("ConstraintIds", "found none", Function="Harmonic")
        self.expect_function_refused("Selection", "found none", Function="Geodesic", SourceType="Selection")

    def test_functions_with_wrong_sources(self):
        self.expect_function_refused("from 0 to 499", "found 500", Function="Geodesic", SourceIds=[1, 500])
        self.expect_function_refused(
            "one value at each place", "point 1", Function="Harmonic", ConstraintIds=[1, 1], ConstraintValues=[0, 1]
        )
        self.expect_function_refused("(2)", "found 1", Function="Harmonic", ConstraintIds=[1, 2], ConstraintValues=[0])

    def test_functions_out_of_range(self):
        self.expect_function_refused("from 0 to 299", "999", Function="LaplacianEigenfunction", EigenIndex=999)
        self.expect_function_refused("triangles", Function="LaplacianEigenfunction", Weights="Cotangent")

    def test_critical_points_without_array(self):
        with support.Messages() as messages:
            critical = simple.FuzzyCriticalPoints(Input=support.source(support.polydata(support.torus_points(500))))
            self.assertEqual(support.fetch(critical).GetNumberOfPoints(), 0)
            self.assertEqual(support.fetch(critical, 1).GetNumberOfPoints(), 0)
        self.assertIn("Fuzzy Critical Points: needs ", messages.text)
        self.assertIn("array", messages.text)

    def test_critical_points_of_an_angle_to_nothing(self):
        points = support.torus_points(500)
        with support.Messages() as messages:
            critical = simple.FuzzyCriticalPoints(
                Input=support.source(support.polydata(points, f=points[:, 0])),
                ScalarArray=["POINTS", "f"],
                ProbabilityModel="NormalAngle",
            )
            self.assertEqual(support.fetch(critical, 1).GetNumberOfPoints(), 0)
        self.assertIn("VolumeFunction", messages.text)


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

"""Critical points through the plugin: both outputs, their arrays, what thresholds and implicit functions do."""

import unittest

import numpy
import support
from paraview import simple
from vtk import vtkDoubleArray, vtkIdTypeArray, vtkIntArray

UP = numpy.array([0.9, 0.2, 0.4]) / numpy.linalg.norm([0.9, 0.2, 0.4])


class TestCriticalPoints(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points = support.torus_points(8000)
        cls.source = support.source(support.polydata(cls.points, f=cls.points @ UP))

    def critical(self, **properties):
        return simple.FuzzyCriticalPoints(Input=self.source, ScalarArray=["POINTS", "f"], **properties)

    def test_a_torus_has_a_minimum_two_saddles_and_a_maximum(self):
        found = support.fetch(self.critical(), 1)
        self.assertEqual(list(support.point_array(found, "CriticalType")), [0, 1, 1, 3])
        self.assertEqual(list(support.point_array(found, "Multiplicity")), [1, 1, 1, 1])
        self.assertEqual(found.GetNumberOfVerts(), 4)
        values = support.point_array(found, "ScalarValue")
        self.assertTrue(numpy.all(numpy.diff(values) >= 0))
        self.assertLess(numpy.abs(values - support.positions(found) @ UP).max(), 0.01)
        self.assertTrue(numpy.all(support.point_array(found, "CriticalProbability") > 0.3))

    def test_point_ids_lead_to_the_first_output(self):
        critical = self.critical()
        samples, found = support.fetch(critical), support.fetch(critical, 1)
        ids = support.point_array(found, "PointId")
        self.assertTrue(
            numpy.array_equal(
                support.point_array(samples, "CriticalType")[ids], support.point_array(found, "CriticalType")
            )
        )
        distances = numpy.linalg.norm(support.positions(samples)[ids] - support.positions(found), axis=1)
        self.assertLess(distances.max(), 0.05)

    def test_arrays(self):
        critical = self.critical()
        samples, found = support.fetch(critical), support.fetch(critical, 1)
        for name, kind in (
            ("CriticalProbability", vtkDoubleArray),
            ("Gradient", vtkDoubleArray),
            ("Normals", vtkDoubleArray),
            ("CriticalType", vtkIntArray),
        ):
            self.assertIsInstance(samples.GetPointData().GetArray(name), kind)
        for name, kind in (
            ("CriticalType", vtkIntArray),
            ("Multiplicity", vtkIntArray),
            ("CriticalProbability", vtkDoubleArray),
            ("ScalarValue", vtkDoubleArray),
            ("PointId", vtkIdTypeArray),
            ("Persistence", vtkDoubleArray),
            ("Residual", vtkDoubleArray),
        ):
            self.assertIsInstance(found.GetPointData().GetArray(name), kind)
        for data in (samples, found):
            self.assertEqual(support.field_array(data, "IndexSum")[0], 0)
        probabilities = support.point_array(samples, "CriticalProbability")
        self.assertTrue(numpy.all((probabilities >= 0) & (probabilities <= 1)))
        self.assertEqual(samples.GetPointData().GetScalars().GetName(), "f")

    def test_thresholds_leave_points_out(self):
        critical = self.critical(PersistenceThreshold=1)
        count = support.fetch(critical, 1).GetNumberOfPoints()
        self.assertLessEqual(count, 4)
        critical = self.critical(ProbabilityThreshold=1)
        self.assertEqual(support.fetch(critical, 1).GetNumberOfPoints(), 0)

    def test_without_refinement_they_are_samples(self):
        found = support.fetch(self.critical(Refine=0), 1)
        ids = support.point_array(found, "PointId")
        self.assertLess(numpy.abs(support.positions(found) - self.points[ids]).max(), 1e-12)

    def test_the_angle_to_a_plane(self):
        critical = self.critical(ProbabilityModel="NormalAngle", VolumeFunction="Plane")
        critical.VolumeFunction.Normal = list(UP)
        samples = support.fetch(critical)
        cosines = numpy.abs(support.point_array(samples, "Normals") @ UP)
        self.assertLess(numpy.abs(support.point_array(samples, "CriticalProbability") - cosines).max(), 0.01)

    def test_a_constant_has_none(self):
        constant = support.source(support.polydata(self.points, f=numpy.full(len(self.points), 3.0)))
        with support.Messages() as messages:
            critical = simple.FuzzyCriticalPoints(Input=constant, ScalarArray=["POINTS", "f"])
            self.assertEqual(support.fetch(critical, 1).GetNumberOfPoints(), 0)
        self.assertIn("a constant function has no critical points", messages.text)
        self.assertEqual(messages.text.lower().count("warning"), 1)

    def test_contours_of_a_height_meet_its_saddles(self):
        """What the two filters are for together: the values where level sets change."""
        critical = self.critical()
        found = support.fetch(critical, 1)
        low, high = support.point_array(found, "ScalarValue")[1:3]
        contour = simple.PointSetContour(
            Input=critical, ScalarArray=["POINTS", "f"], ContourValues=[low - 0.05, 0.5 * (low + high), high + 0.05]
        )
        counts = list(support.field_array(support.fetch(contour), "ComponentCounts"))
        self.assertEqual(counts, [1, 2, 1])


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

"""Functions on the surface through the plugin: sources by id, by selection, by a place; meshes; blocks."""

import unittest

import numpy
import support
from paraview import simple


def result(function):
    data = support.fetch(function)
    return support.point_array(data, data.GetPointData().GetScalars().GetName())


class TestFunctions(unittest.TestCase):
    def setUp(self):
        points = numpy.random.RandomState(1).normal(size=(2000, 3))
        self.points = points / numpy.linalg.norm(points, axis=1)[:, None]
        self.source = support.source(support.polydata(self.points))

    def function(self, name, **properties):
        return simple.PointSetScalarFunction(Input=self.source, Function=name, **properties)

    def arcs_from(self, point):
        return numpy.arccos(numpy.clip(self.points @ self.points[point], -1, 1))

    def test_geodesic_distance_is_the_arc(self):
        distances = result(self.function("Geodesic", SourceIds=[17]))
        self.assertLess(numpy.abs(distances - self.arcs_from(17)).mean(), 0.05)
        self.assertEqual(distances[17], 0)

    def test_selected_points_are_sources(self):
        selection = simple.IDSelectionSource(IDs=[0, 44, 0, 3], FieldType="POINT")
        selected = self.function("Geodesic", SourceType="Selection", Selection=selection)
        given = self.function("Geodesic", SourceIds=[3, 44])
        self.assertTrue(numpy.array_equal(result(selected), result(given)))

    def test_a_selection_can_be_taken_away(self):
        function = self.function("Geodesic", SourceIds=[3], SourceType="Selection")
        function.Selection = simple.IDSelectionSource(IDs=[0, 44], FieldType="POINT")
        self.assertEqual(result(function)[44], 0)
        function.Selection = None
        function.SourceType = "Ids"
        self.assertEqual(result(function)[3], 0)

    def test_the_point_nearest_to_a_place_is_the_source(self):
        nearest = numpy.argmax(self.points @ [0.6, 0, 0.8])
        function = self.function("Geodesic", SourceType="Point", SourcePoint=[6, 0, 8])
        self.assertEqual(result(function)[nearest], 0)

    def test_harmonic_functions_stay_between_their_constraints(self):
        function = self.function("Harmonic", ConstraintIds=[5, 900], ConstraintValues=[-1, 3])
        for weights in ("Gaussian", "DensityNormalized", "LocalScale"):
            function.Weights = weights
            values = result(function)
            self.assertAlmostEqual(values[5], -1)
            self.assertAlmostEqual(values[900], 3)
            self.assertGreaterEqual(values.min(), -1 - 1e-9)
            self.assertLessEqual(values.max(), 3 + 1e-9)

    def test_the_ends_of_a_line_are_constraints(self):
        low, high = numpy.argmin(self.points[:, 2]), numpy.argmax(self.points[:, 2])
        function = self.function(
            "Harmonic", SourceType="Point", ConstraintPoint1=[0, 0, -2], ConstraintPoint2=[0, 0, 2]
        )
        self.assertAlmostEqual(result(function)[low], 0)
        self.assertAlmostEqual(result(function)[high], 1)
        function.ConstraintValues = [7, -2]
        self.assertAlmostEqual(result(function)[low], 7)
        self.assertAlmostEqual(result(function)[high], -2)

    def test_eigenvalues_of_the_sphere(self):
        function = self.function("LaplacianEigenfunction")
        for index, expected in ((1, 2), (3, 2), (4, 6)):
            function.EigenIndex = index
            data = support.fetch(function)
            self.assertAlmostEqual(support.field_array(data, "Eigenvalue")[0], expected, delta=0.15 * expected)

    def test_heat_decays_with_the_distance(self):
        heat = result(self.function("Diffusion", SourceIds=[17], DiffusionTime=0.1))
        arcs = self.arcs_from(17)
        self.assertGreater(heat[arcs < 0.2].min(), heat[arcs > 0.6].max())

    def test_meshes(self):
        sphere = simple.Sphere(ThetaResolution=40, PhiResolution=40)
        function = simple.PointSetScalarFunction(
            Input=sphere, Function="LaplacianEigenfunction", Weights="Cotangent", EigenIndex=2
        )
        data = support.fetch(function)
        self.assertAlmostEqual(support.field_array(data, "Eigenvalue")[0], 2 / 0.25, delta=0.1)
        self.assertEqual(data.GetNumberOfPolys(), support.fetch(sphere).GetNumberOfPolys())

    def test_ids_count_through_blocks(self):
        groups = simple.GroupDatasets(
            Input=[support.source(support.polydata(part)) for part in (self.points[:700], self.points[700:])]
        )
        merged = simple.PointSetScalarFunction(Input=groups, Function="Geodesic", SourceIds=[1200])
        whole = self.function("Geodesic", SourceIds=[1200])
        self.assertTrue(numpy.array_equal(result(merged), result(whole)))


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

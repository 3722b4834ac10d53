"""Contours through the plugin: the scan that ships, every output array, iso-values in any number."""

import unittest

import numpy
import support
from paraview import simple
from vtk import vtkDoubleArray


def segment_lengths(contours, cell):
    ids = [contours.GetCell(cell).GetPointId(i) for i in range(contours.GetCell(cell).GetNumberOfPoints())]
    corners = support.positions(contours)[ids]
    return ids, numpy.linalg.norm(numpy.diff(corners, axis=0), axis=1)


class TestContour(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scan = support.source(support.polydata(support.kitten_points()))
        cls.height = simple.PointSetScalarFunction(Input=scan, Function="Height", Direction=[0, 1, 0])
        low, high = support.fetch(cls.height).GetPointData().GetArray("Height").GetRange()
        cls.values = list(numpy.linspace(low, high, 12)[1:-1])
        cls.filter = simple.PointSetContour(
            Input=cls.height, ScalarArray=["POINTS", "Height"], ContourValues=cls.values
        )
        cls.contours = support.fetch(cls.filter)
        cls.samples = support.fetch(cls.filter, 1)

    def test_the_height_is_the_coordinate(self):
        dataset = support.fetch(self.height)
        self.assertTrue(numpy.allclose(support.point_array(dataset, "Height"), support.positions(dataset)[:, 1]))

    def test_every_iso_value_of_the_scan_has_curves(self):
        self.assertTrue(numpy.allclose(support.field_array(self.contours, "IsoValues"), self.values))
        counts = support.field_array(self.contours, "ComponentCounts")
        self.assertEqual(len(counts), len(self.values))
        self.assertTrue(numpy.all(counts >= 1))
        self.assertEqual(counts.sum(), self.contours.GetNumberOfLines())
        self.assertEqual(self.contours.GetNumberOfCells(), self.contours.GetNumberOfLines())

    def test_components_are_numbered_within_their_iso_value(self):
        iso_values = support.cell_array(self.contours, "IsoValue")
        components = support.cell_array(self.contours, "ComponentId")
        for value, count in zip(self.values, support.field_array(self.contours, "ComponentCounts")):
            self.assertEqual(sorted(components[numpy.isclose(iso_values, value)]), list(range(count)))

    def test_closed_curves_return_to_their_first_point(self):
        closed = support.cell_array(self.contours, "Closed")
        self.assertTrue(set(closed) <= {0, 1})
        self.assertGreater(closed.sum(), 0)  # the scan is of a closed surface
        for cell in range(self.contours.GetNumberOfCells()):
            ids, lengths = segment_lengths(self.contours, cell)
            self.assertEqual(ids[0] == ids[-1], bool(closed[cell]))
            self.assertAlmostEqual(lengths.sum(), support.cell_array(self.contours, "Length")[cell], places=10)
            self.assertGreater(lengths.min(), 0)

    def test_points_lie_at_their_height(self):
        heights = support.point_array(self.contours, "Height")
        size = self.values[-1] - self.values[0]
        self.assertLess(numpy.abs(heights - support.positions(self.contours)[:, 1]).max(), 0.01 * size)
        self.assertTrue(set(heights) <= set(support.field_array(self.contours, "IsoValues")))

    def test_point_arrays(self):
        normals = support.point_array(self.contours, "Normals")
        self.assertTrue(numpy.allclose(numpy.linalg.norm(normals, axis=1), 1))
        residuals = support.point_array(self.contours, "Residual")
        self.assertTrue(numpy.all(numpy.isfinite(residuals)) and numpy.all(residuals >= 0))
        for name in ("Height", "Normals", "Residual"):
            self.assertIsInstance(self.contours.GetPointData().GetArray(name), vtkDoubleArray)
        self.assertIsInstance(self.contours.GetPoints().GetData(), vtkDoubleArray)

    def test_samples_are_vertices_with_the_same_arrays(self):
        self.assertGreater(self.samples.GetNumberOfPoints(), 100)
        self.assertEqual(self.samples.GetNumberOfVerts(), self.samples.GetNumberOfPoints())
        for name in ("Height", "Normals", "Residual", "Converged"):
            self.assertIsNotNone(self.samples.GetPointData().GetArray(name), name)
        self.assertTrue(set(support.point_array(self.samples, "Converged")) <= {0, 1})

    def test_iso_values_outside_the_range_give_nothing(self):
        contour = simple.PointSetContour(Input=self.height, ContourValues=[1e3, -1e3])
        with support.Messages() as messages:
            contours = support.fetch(contour)
        self.assertEqual(messages.text, "")
        self.assertEqual(contours.GetNumberOfPoints(), 0)
        self.assertEqual(list(support.field_array(contours, "ComponentCounts")), [0, 0])

    def test_all_schemes_find_the_curves(self):
        for scheme in ("Linear", "ExplicitMLS", "ParameterizedMLS"):
            for surface in ("MLS", "Unprojected"):
                contour = simple.PointSetContour(
                    Input=self.height, ContourValues=self.values[3:6], Scheme=scheme, SurfaceModel=surface
                )
                counts = support.field_array(support.fetch(contour), "ComponentCounts")
                self.assertTrue(numpy.all(counts >= 1), (scheme, surface))

    def test_evenly_spaced_smooth_curves(self):
        spacing = 0.01
        contour = simple.PointSetContour(
            Input=self.height, ContourValues=[self.values[4]], Fit="LeastSquares", SampleSpacing=spacing
        )
        contours = support.fetch(contour)
        self.assertGreater(contours.GetNumberOfCells(), 0)
        for cell in range(contours.GetNumberOfCells()):
            _, lengths = segment_lengths(contours, cell)
            self.assertLess(numpy.abs(lengths - lengths.mean()).max(), 0.1 * spacing)
            self.assertLess(abs(lengths.mean() - spacing), 0.2 * spacing)


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

"""Level Set Distribution as a Python user meets it: tables, charts, the list of iso-values, volumes."""

import os
import unittest

import numpy
import support
from paraview import servermanager, simple


def covered_share(dataset):
    """The share of the area of the covered triangles."""
    points = support.positions(dataset)
    corners = support.vtk_to_numpy(dataset.GetPolys().GetData()).reshape(-1, 4)[:, 1:]
    a, b, c = (points[corners[:, i]] for i in range(3))
    areas = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)
    return areas[support.cell_array(dataset, "Covered") == 1].sum() / areas.sum()


def meeting_share(points, triangles, values, isovalues):
    """The same by the definition, for all triangles and values."""
    low, high = values[triangles].min(axis=1), values[triangles].max(axis=1)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    areas = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)
    met = ((low[:, None] <= isovalues) & (isovalues <= high[:, None])).any(axis=1)
    return areas[met].sum() / areas.sum()


def crossings(points, triangles, values, level):
    """The points in which edges cross a value."""
    edges = numpy.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    ends = values[edges]
    edges = edges[(ends < level).any(axis=1) & (ends >= level).any(axis=1)]
    t = (level - values[edges[:, 0]]) / (values[edges[:, 1]] - values[edges[:, 0]])
    return points[edges[:, 0]] + t[:, None] * (points[edges[:, 1]] - points[edges[:, 0]])


def hausdorff(one, other):
    distances = numpy.linalg.norm(one[:, None] - other, axis=2)
    return max(distances.min(axis=1).max(), distances.min(axis=0).max())


class TestDistribution(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = support.torus_mesh()
        self.values = self.points @ [0.9, 0.2, 0.4]
        self.torus = support.source(support.mesh(self.points, self.triangles, f=self.values))

    def distribution(self, source=None, **properties):
        return simple.LevelSetDistribution(
            Input=source or self.torus, ScalarArray=["POINTS", "f"], CoverageTolerance=0.02, **properties)

    def test_coverage_is_a_sum_of_areas(self):
        proxy = self.distribution()
        mesh, table = support.fetch(proxy), support.fetch(proxy, 1)
        optimal = support.field_array(mesh, "OptimalIsoValues")
        counts = support.table_column(table, "IsoValueCount")
        coverages = support.table_column(table, "Coverage")
        self.assertEqual(len(optimal), counts[-1])
        self.assertAlmostEqual(coverages[-1], support.field_array(mesh, "GlobalCoverage")[0], places=15)
        self.assertAlmostEqual(coverages[-1], covered_share(mesh), places=12)
        for k, count in enumerate(counts):
            step = (len(optimal) + 1) // (count + 1)
            share = meeting_share(self.points, self.triangles, self.values, optimal[step - 1 :: step])
            self.assertAlmostEqual(coverages[k], share, places=12)

    def test_distortion_is_a_hausdorff_distance(self):
        table = support.fetch(self.distribution(), 2)
        columns = [support.table_column(table, name) for name in ("IsoValue", "NextIsoValue", "Distortion")]
        self.assertGreater(len(columns[0]), 10)
        for low, high, distance in zip(*columns):
            one, other = (crossings(self.points, self.triangles, self.values, level) for level in (low, high))
            self.assertAlmostEqual(distance, hausdorff(one, other), places=12)

    def test_ways_along_the_surface_are_longer(self):
        straight, along = (
            support.table_column(support.fetch(self.distribution(DistanceMeasure=measure, MaximumIntervals=8), 2),
                                 "Distortion")
            for measure in ("Hausdorff", "Geodesic")
        )
        self.assertEqual(len(straight), len(along))
        self.assertTrue((along > 0.95 * straight).all())

    def test_a_contour_takes_the_iso_values_as_they_are(self):
        proxy = self.distribution()
        values = support.field_array(support.fetch(proxy), "OptimalIsoValues").tolist()
        contour = simple.Contour(Input=simple.OutputPort(proxy, 0), ContourBy=["POINTS", "f"], Isosurfaces=values)
        found = numpy.unique(numpy.round(support.point_array(support.fetch(contour), "f"), 9))
        self.assertEqual(len(found), len(values))
        self.assertLess(numpy.abs(found - values).max(), 1e-6)

    def test_tables_are_for_line_charts(self):
        """As a user draws them."""
        proxy = self.distribution()
        for port, abscissa, ordinate in ((1, "IsoValueCount", "Coverage"), (2, "IsoValue", "Distortion")):
            view = simple.CreateView("XYChartView")
            chart = simple.Show(simple.OutputPort(proxy, port), view)
            chart.UseIndexForXAxis = 0
            chart.XArrayName = abscissa
            chart.SeriesVisibility = [ordinate]
            chart.UpdatePipeline()
            self.assertEqual(list(chart.SeriesVisibility), [ordinate])
            simple.Delete(view)

    def test_images_and_tetrahedra_are_volumes(self):
        image = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])
        for volume in (image, simple.Tetrahedralize(Input=image)):
            proxy = simple.LevelSetDistribution(
                Input=volume, ScalarArray=["POINTS", "RTData"], CoverageTolerance=0.02, MaximumIntervals=32)
            with support.Messages() as messages:
                data = support.fetch(proxy)
            self.assertEqual(messages.text, "")
            self.assertEqual(data.GetNumberOfCells(), support.fetch(volume).GetNumberOfCells())
            self.assertGreater(support.field_array(data, "GlobalCoverage")[0], 0.9)
            self.assertGreater(support.fetch(proxy, 2).GetNumberOfRows(), 0)

    def test_integer_heights_of_a_terrain_are_flat_in_places(self):
        """Real data: heights in whole meters, so that triangles between equal ones are not covered."""
        terrain = simple.OpenDataFile(os.path.join(os.environ["SURFACE_SCALARS_DATA"], "jacksboro.vtk"))
        data = support.fetch(simple.LevelSetDistribution(Input=terrain, ScalarArray=["POINTS", "Elevation"]))
        self.assertLess(support.field_array(data, "GlobalCoverage")[0], 0.999)

    def test_blocks_have_tables_of_their_own(self):
        group = simple.GroupDatasets(Input=[self.torus, self.torus])
        proxy = self.distribution(group)
        for port in range(3):
            self.assertEqual(support.fetch(proxy, port).GetNumberOfBlocks(), 2)
        rows = [support.fetch(proxy, 1).GetBlock(i).GetNumberOfRows() for i in (0, 1)]
        self.assertEqual(rows[0], rows[1])
        self.assertGreater(rows[0], 3)

    def test_a_tolerance_of_nothing_is_refused(self):
        proxy = self.distribution()
        proxy.CoverageTolerance = 0
        with support.Messages() as messages:
            self.assertEqual(support.fetch(proxy).GetNumberOfPoints(), 0)
        self.assertIn("Level Set Distribution: needs a CoverageTolerance above 0", messages.text)

    def test_a_constant_is_warned_of(self):
        constant = support.source(support.mesh(self.points, self.triangles, f=numpy.ones(len(self.points))))
        with support.Messages() as messages:
            data = support.fetch(self.distribution(constant))
        self.assertIn("no iso-values", messages.text)
        self.assertEqual(support.field_array(data, "GlobalCoverage")[0], 0)

    def test_a_state_keeps_the_properties(self):
        sphere = simple.Sphere(ThetaResolution=30, PhiResolution=30)
        height = simple.PointSetScalarFunction(Input=sphere, Function="Height")
        simple.LevelSetDistribution(
            registrationName="Levels", Input=height, ScalarArray=["POINTS", "Height"], CoverageTolerance=0.125,
            DistanceMeasure="Geodesic", PersistenceThreshold=0.25, MaximumIntervals=16)
        path = support.output_file("levels.pvsm")
        servermanager.SaveState(path)
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)
        simple.LoadState(path)
        levels = simple.FindSource("Levels")
        self.assertEqual(
            [levels.CoverageTolerance, levels.DistanceMeasure, levels.PersistenceThreshold, levels.MaximumIntervals],
            [0.125, "Geodesic", 0.25, 16])
        self.assertGreater(support.fetch(levels, 2).GetNumberOfRows(), 0)


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

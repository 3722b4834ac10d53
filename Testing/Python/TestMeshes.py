"""Critical points and Morse complexes of functions on meshes through the plugin."""

import os
import unittest

import numpy
import support
from paraview import servermanager, simple
from vtk import vtkDoubleArray, vtkIdTypeArray, vtkIntArray

UP = numpy.array([0.9, 0.2, 0.4]) / numpy.linalg.norm([0.9, 0.2, 0.4])


def noisy_torus():
    """A closed torus with noise of half the range of its height."""
    points, triangles = support.torus_mesh()
    height = points @ UP
    noise = numpy.random.RandomState(1).uniform(size=len(points))
    return support.mesh(points, triangles, f=height + 0.5 * numpy.ptp(height) * noise)


class TestMeshes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        points, triangles = support.torus_mesh()
        cls.torus = support.source(support.mesh(points, triangles, f=points @ UP))
        cls.noisy = support.source(noisy_torus())

    def tearDown(self):
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)

    def test_a_torus_has_a_minimum_two_saddles_and_a_maximum(self):
        critical = simple.MeshCriticalPoints(Input=self.torus, ScalarArray=["POINTS", "f"])
        mesh, found = support.fetch(critical), support.fetch(critical, 1)
        self.assertEqual(sorted(support.point_array(found, "CriticalType")), [0, 1, 1, 3])
        values = support.point_array(found, "ScalarValue")
        self.assertLess(numpy.abs(values - support.positions(found) @ UP).max(), 1e-12)
        ids = support.point_array(found, "PointId")
        self.assertTrue(numpy.array_equal(support.positions(mesh)[ids], support.positions(found)))
        for dataset in (mesh, found):
            self.assertEqual(list(support.field_array(dataset, "CriticalCounts")), [1, 2, 1])
            self.assertEqual(list(support.field_array(dataset, "EulerCharacteristic")), [0])

    def test_a_model_takes_the_place_of_the_array(self):
        extend = simple.RBFExtend(Input=self.torus, Target=self.torus, Scheme="GlobalRBF", ScalarArray=["POINTS", "f"])
        bare = simple.PassArrays(Input=self.torus, PointDataArrays=[])
        critical = simple.MeshCriticalPoints(Input=bare, Model=servermanager.OutputPort(extend, 1))
        mesh, found = support.fetch(critical), support.fetch(critical, 1)
        self.assertEqual(sorted(support.point_array(found, "CriticalType")), [0, 1, 1, 3])
        self.assertEqual(list(support.point_array(found, "Refined")), [1, 1, 1, 1])
        self.assertLessEqual(support.point_array(found, "Iterations").max(), 10)
        scale = support.field_array(found, "GradientScale")[0]
        self.assertLessEqual(support.point_array(found, "Residual").max(), 1e-10 * scale)
        self.assertEqual(list(support.field_array(mesh, "IndexSum")), [0])
        # The height of a torus is critical where the normal is upright: refined places are much closer to that.
        values = support.point_array(found, "ScalarValue")
        self.assertLess(numpy.abs(values - support.positions(found) @ UP).max(), 1e-6)
        with_array = simple.MeshCriticalPoints(Input=self.torus, Model=servermanager.OutputPort(extend, 1))
        with_array.Model = None
        self.assertIsNone(support.fetch(with_array, 1).GetPointData().GetArray("Refined"))

    def test_a_threshold_keeps_what_is_persistent_up_to_the_boundary(self):
        for name, array in (("jacksboro.vtk", "Elevation"), ("ctcbay.vtk", "Depth")):
            data = simple.OpenDataFile(os.path.join(os.environ["SURFACE_SCALARS_DATA"], name))
            surface = simple.ExtractSurface(Input=data)
            critical = simple.MeshCriticalPoints(Input=surface, ScalarArray=["POINTS", array])
            persistence = support.point_array(support.fetch(critical, 1), "Persistence")
            ids = support.point_array(support.fetch(critical, 1), "PointId")
            values = support.point_array(support.fetch(critical), array).astype(float)
            for threshold in (0.02, 0.1, 0.3):
                critical.PersistenceThreshold = threshold
                kept = support.point_array(support.fetch(critical, 1), "PointId")
                self.assertEqual(list(kept), list(ids[persistence >= threshold * numpy.ptp(values)]))

    def test_arrays(self):
        critical = simple.MeshCriticalPoints(Input=self.noisy)
        found, pairs = support.fetch(critical, 1), support.fetch(critical, 2)
        for name, kind in (
            ("CriticalType", vtkIntArray),
            ("Multiplicity", vtkIntArray),
            ("ScalarValue", vtkDoubleArray),
            ("PointId", vtkIdTypeArray),
            ("Persistence", vtkDoubleArray),
        ):
            self.assertIsInstance(found.GetPointData().GetArray(name), kind)
        self.assertIsInstance(pairs.GetCellData().GetArray("Persistence"), vtkDoubleArray)
        self.assertIsInstance(pairs.GetCellData().GetArray("PairType"), vtkIntArray)
        self.assertEqual(set(support.cell_array(pairs, "PairType")), {0, 1})

    def test_the_table_says_what_thresholds_leave(self):
        critical = simple.MeshCriticalPoints(Input=self.noisy)
        table = support.fetch(critical, 3)
        thresholds = support.table_column(table, "Threshold")
        row = int(numpy.searchsorted(thresholds, 0.2))
        critical.PersistenceThreshold = thresholds[row]
        self.assertEqual(
            list(support.field_array(support.fetch(critical), "CriticalCounts")),
            [support.table_column(table, "Persistence" + kind)[row] for kind in ("Minima", "Saddles", "Maxima")],
        )

    def test_the_table_is_for_a_line_chart(self):
        """As a user draws it: the counts against the threshold."""
        critical = simple.MeshCriticalPoints(Input=self.noisy)
        view = simple.CreateView("XYChartView")
        chart = simple.Show(simple.OutputPort(critical, 3), view)
        chart.UseIndexForXAxis = 0
        chart.XArrayName = "Threshold"
        chart.SeriesVisibility = ["PersistenceMinima", "PersistenceMaxima"]
        chart.UpdatePipeline()
        self.assertEqual(chart.XArrayName, "Threshold")
        self.assertIn("PersistenceMinima", list(chart.SeriesVisibility))
        simple.Delete(view)

    def test_separatrices_join_nodes(self):
        morse = simple.MorseComplex(Input=self.torus, ScalarArray=["POINTS", "f"])
        paths, nodes = support.fetch(morse), support.fetch(morse, 1)
        self.assertEqual(paths.GetNumberOfLines(), 8)
        types = support.point_array(nodes, "CriticalType")
        self.assertEqual(set(types[support.cell_array(paths, "SourceId")]), {1})
        up = support.cell_array(paths, "SeparatrixType")
        self.assertTrue(
            numpy.array_equal(types[support.cell_array(paths, "DestinationId")], numpy.where(up == 1, 3, 0))
        )
        values = support.point_array(nodes, "ScalarValue")
        heights = numpy.abs(
            values[support.cell_array(paths, "SourceId")] - values[support.cell_array(paths, "DestinationId")]
        )
        self.assertLess(numpy.abs(support.cell_array(paths, "Persistence") - heights).max(), 1e-12)

    def test_a_threshold_simplifies_the_complex(self):
        morse = simple.MorseComplex(Input=self.noisy, ScalarArray=["POINTS", "f"])
        count = support.fetch(morse).GetNumberOfLines()
        morse.PersistenceThreshold = 0.55
        self.assertLess(support.fetch(morse).GetNumberOfLines(), count / 10)
        self.assertEqual(list(support.field_array(support.fetch(morse, 1), "CriticalCounts")), [1, 2, 1])

    def test_sources_of_paraview_are_meshes(self):
        """Triangles, quads and strips as its own sources make them."""
        for source, euler in (
            (simple.Sphere(ThetaResolution=20, PhiResolution=20), 2),
            (simple.Plane(XResolution=10, YResolution=10), 1),
            (simple.Superquadric(Toroidal=1), 0),
        ):
            clean = simple.Clean(Input=source)
            height = simple.Elevation(Input=clean, LowPoint=[-0.3, -0.5, -0.4], HighPoint=[0.2, 0.5, 0.5])
            critical = simple.MeshCriticalPoints(Input=height, ScalarArray=["POINTS", "Elevation"])
            with support.Messages() as messages:
                mesh = support.fetch(critical)
            self.assertEqual(list(support.field_array(mesh, "EulerCharacteristic")), [euler], messages.text)
            self.assertEqual(messages.text, "")

    def test_blocks_are_worked_on_one_by_one(self):
        group = simple.GroupDatasets(Input=[self.torus, self.noisy])
        for proxy, ports in (
            (simple.MeshCriticalPoints(Input=group, ScalarArray=["POINTS", "f"]), 4),
            (simple.MorseComplex(Input=group, ScalarArray=["POINTS", "f"]), 2),
        ):
            for port in range(ports):
                blocks = support.fetch(proxy, port)
                self.assertTrue(blocks.IsA("vtkCompositeDataSet"))
            iterator = support.fetch(proxy, 1).NewIterator()
            counts = []
            while not iterator.IsDoneWithTraversal():
                counts.append(iterator.GetCurrentDataObject().GetNumberOfPoints())
                iterator.GoToNextItem()
            self.assertEqual(len(counts), 2)
            self.assertEqual(counts[0], 4)
            self.assertGreater(counts[1], 100)

    def test_points_are_referred_to_the_point_set_filters(self):
        points = support.torus_points(100)
        cloud = support.source(support.polydata(points, f=points[:, 2]))
        for proxy, speaker in (
            (simple.MeshCriticalPoints(Input=cloud), "Mesh Critical Points: "),
            (simple.MorseComplex(Input=cloud), "Morse Complex: "),
        ):
            with support.Messages() as messages:
                self.assertEqual(support.fetch(proxy).GetNumberOfPoints(), 0)
            self.assertIn(speaker + "needs a mesh", messages.text)
            self.assertIn("Fuzzy Critical Points", messages.text)

    def test_a_state_keeps_the_thresholds(self):
        sphere = simple.Sphere(ThetaResolution=30, PhiResolution=30)
        height = simple.PointSetScalarFunction(Input=sphere, Function="Height")
        simple.MeshCriticalPoints(
            registrationName="Critical", Input=height, ScalarArray=["POINTS", "Height"],
            PersistenceThreshold=0.25, Delta=0.125)
        simple.MorseComplex(
            registrationName="Morse", Input=height, ScalarArray=["POINTS", "Height"], PersistenceThreshold=0.5)
        path = support.output_file("meshes.pvsm")
        servermanager.SaveState(path)
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)
        simple.LoadState(path)
        critical, morse = simple.FindSource("Critical"), simple.FindSource("Morse")
        self.assertEqual(list(critical.ScalarArray), ["POINTS", "Height"])
        self.assertEqual([critical.PersistenceThreshold, critical.Delta], [0.25, 0.125])
        self.assertEqual(morse.PersistenceThreshold, 0.5)
        self.assertEqual(list(support.field_array(support.fetch(morse), "CriticalCounts")), [1, 0, 1])


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

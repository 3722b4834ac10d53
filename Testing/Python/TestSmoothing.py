"""Constrained smoothing through the plugin: what is kept, what is written, what is refused, time steps and blocks."""

import unittest

import numpy
import support
from paraview import servermanager, simple
from vtk import vtkDoubleArray, vtkIntArray

UP = numpy.array([0.9, 0.2, 0.4]) / numpy.linalg.norm([0.9, 0.2, 0.4])

NOISY_STEPS = """
import numpy
from vtk.util.numpy_support import numpy_to_vtk
executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
time = 0.0
if information.Has(executive.UPDATE_TIME_STEP()):
    time = information.Get(executive.UPDATE_TIME_STEP())
import vtk
sphere = vtk.vtkSphereSource()
sphere.SetThetaResolution(40)
sphere.SetPhiResolution(40)
sphere.Update()
output = self.GetOutput()
output.ShallowCopy(sphere.GetOutput())
points = vtk.util.numpy_support.vtk_to_numpy(output.GetPoints().GetData())
angle = 0.5 * time
values = points @ [numpy.cos(angle), 0.0, numpy.sin(angle)]
values = values + 0.1 * numpy.random.RandomState(int(time)).normal(size=len(values))
array = numpy_to_vtk(values, deep=True)
array.SetName('f')
output.GetPointData().SetScalars(array)
output.GetInformation().Set(output.DATA_TIME_STEP(), time)
"""


def noisy_values(points, seed=1, noise=0.05):
    height = points @ UP
    return height + noise * numpy.ptp(height) * numpy.random.RandomState(seed).normal(size=len(points))


class TestSmoothing(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles = support.torus_mesh()
        mask = numpy.zeros(len(cls.points))
        mask[[3, 400, 800, 1100]] = 1
        cls.dataset = support.mesh(cls.points, cls.triangles, f=noisy_values(cls.points), mask=mask)
        cls.source = support.source(cls.dataset)

    def tearDown(self):
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)

    def smoothing(self, **properties):
        return simple.ConstrainedSmoothing(Input=self.source, ScalarArray=["POINTS", "f"], **properties)

    def test_the_features_of_a_torus_are_kept_and_no_others(self):
        smoothing = self.smoothing(PersistenceThreshold=0.1)
        with support.Messages() as messages:
            mesh, found = support.fetch(smoothing), support.fetch(smoothing, 1)
        self.assertEqual(messages.text, "")
        self.assertGreater(support.field_array(mesh, "InputCriticalCounts").sum(), 200)
        self.assertEqual(list(support.field_array(mesh, "OutputCriticalCounts")), [1, 2, 1])
        self.assertEqual(list(support.field_array(mesh, "EulerCharacteristic")), [0])
        self.assertEqual(sorted(support.point_array(found, "CriticalType")), [0, 1, 1, 3])
        again = simple.MeshCriticalPoints(Input=smoothing, ScalarArray=["POINTS", "SmoothedScalars"])
        self.assertTrue(
            numpy.array_equal(
                support.point_array(support.fetch(again, 1), "PointId"), support.point_array(found, "PointId")
            )
        )
        clean = self.points @ UP
        smooth, noisy = support.point_array(mesh, "SmoothedScalars"), support.point_array(mesh, "f")
        self.assertLess(numpy.linalg.norm(smooth - clean), 0.4 * numpy.linalg.norm(noisy - clean))

    def test_field_data(self):
        mesh = support.fetch(self.smoothing(PersistenceThreshold=0.1))
        for name, kind, count in (
            ("InputCriticalCounts", vtkIntArray, 3),
            ("OutputCriticalCounts", vtkIntArray, 3),
            ("EulerCharacteristic", vtkIntArray, 1),
            ("LInfinityError", vtkDoubleArray, 1),
            ("SobolevSeminorm", vtkDoubleArray, 1),
            ("Epsilon", vtkDoubleArray, 1),
        ):
            array = mesh.GetFieldData().GetArray(name)
            self.assertIsInstance(array, kind)
            self.assertEqual(array.GetNumberOfTuples(), count)
        smooth, noisy = support.point_array(mesh, "SmoothedScalars"), support.point_array(mesh, "f")
        self.assertAlmostEqual(support.field_array(mesh, "LInfinityError")[0], numpy.abs(smooth - noisy).max())

    def test_the_curve_is_for_a_line_chart(self):
        smoothing = self.smoothing(Method="Tikhonov")
        table = support.fetch(smoothing, 2)
        epsilons = support.table_column(table, "Epsilon")
        self.assertTrue(numpy.all(numpy.diff(epsilons) > 0))
        self.assertGreater(support.table_column(table, "Residual")[0], support.table_column(table, "Residual")[-1])
        self.assertLess(support.table_column(table, "Seminorm")[0], support.table_column(table, "Seminorm")[-1])
        view = simple.CreateView("XYChartView")
        chart = simple.Show(simple.OutputPort(smoothing, 2), view)
        chart.UseIndexForXAxis = 0
        chart.XArrayName = "Epsilon"
        chart.SeriesVisibility = ["GCV"]
        chart.UpdatePipeline()
        self.assertEqual(chart.XArrayName, "Epsilon")
        simple.Delete(view)

    def test_marked_points_are_interpolated(self):
        for array in ("mask", ["POINTS", "mask"]):
            smoothing = self.smoothing(
                Method="InterpolatingConstraints", Constraints="MaskArray", ConstraintArray=array, IncludeOneStars=0
            )
            mesh = support.fetch(smoothing)
            marked = support.point_array(mesh, "mask") == 1
            smooth, noisy = support.point_array(mesh, "SmoothedScalars"), support.point_array(mesh, "f")
            self.assertLess(numpy.abs(smooth - noisy)[marked].max(), 1e-9)
            self.assertGreater(numpy.abs(smooth - noisy)[~marked].max(), 0.01)

    def test_every_method_and_choice_gives_a_result(self):
        for method in ("FeaturePreserving", "Tikhonov", "InterpolatingConstraints", "LeastSquaresConstraints"):
            for constraints in ("AllCriticalPoints", "DeltaSimplified", "Persistent", "MaskArray"):
                smoothing = self.smoothing(
                    Method=method, Constraints=constraints, ConstraintArray="mask", Delta=0.01, PersistenceThreshold=0.1
                )
                with support.Messages() as messages:
                    mesh = support.fetch(smoothing)
                self.assertNotIn("ERROR", messages.text)
                self.assertTrue(numpy.all(numpy.isfinite(support.point_array(mesh, "SmoothedScalars"))))

    def expect_refused(self, *words, **properties):
        with support.Messages() as messages:
            smoothing = self.smoothing(**properties)
            for port in (0, 1):
                self.assertEqual(support.fetch(smoothing, port).GetNumberOfPoints(), 0)
            self.assertEqual(support.fetch(smoothing, 2).GetNumberOfColumns(), 0)
        self.assertIn("Constrained Smoothing: needs ", messages.text)
        for word in words:
            self.assertIn(word, messages.text)

    def test_refusals(self):
        self.expect_refused("Epsilon above 0", EpsilonChoice="Manual", Epsilon=0)
        self.expect_refused("PersistenceThreshold", "1.5", PersistenceThreshold=1.5)
        self.expect_refused("Delta", "-1", Delta=-1)
        self.expect_refused("'nope'", "none of this name", Constraints="MaskArray", ConstraintArray="nope")

    def test_time_steps(self):
        """The mesh stays, f changes: each step is smoothed as if it were alone."""
        series = support.three_steps(NOISY_STEPS)
        smoothing = simple.ConstrainedSmoothing(
            Input=series, ScalarArray=["POINTS", "f"], PersistenceThreshold=0.3
        )
        for time in (0.0, 1.0, 2.0, 0.0):
            smoothing.UpdatePipeline(time)
            mesh = smoothing.GetClientSideObject().GetOutputDataObject(0)
            self.assertEqual(list(support.field_array(mesh, "OutputCriticalCounts")), [1, 0, 1])
            alone = simple.ConstrainedSmoothing(
                Input=series, ScalarArray=["POINTS", "f"], PersistenceThreshold=0.3
            )
            alone.UpdatePipeline(time)
            expected = alone.GetClientSideObject().GetOutputDataObject(0)
            self.assertTrue(
                numpy.array_equal(
                    support.point_array(mesh, "SmoothedScalars"), support.point_array(expected, "SmoothedScalars")
                )
            )

    def test_blocks_are_smoothed_one_by_one(self):
        other = support.source(support.mesh(self.points, self.triangles, f=noisy_values(self.points, seed=2)))
        group = simple.GroupDatasets(Input=[self.source, other])
        smoothing = simple.ConstrainedSmoothing(Input=group, ScalarArray=["POINTS", "f"], PersistenceThreshold=0.1)
        iterator = support.fetch(smoothing).NewIterator()
        blocks = []
        while not iterator.IsDoneWithTraversal():
            blocks.append(iterator.GetCurrentDataObject())
            iterator.GoToNextItem()
        self.assertEqual(len(blocks), 2)
        for block, source in zip(blocks, (self.source, other)):
            self.assertEqual(list(support.field_array(block, "OutputCriticalCounts")), [1, 2, 1])
            alone = simple.ConstrainedSmoothing(
                Input=source, ScalarArray=["POINTS", "f"], PersistenceThreshold=0.1
            )
            self.assertTrue(
                numpy.array_equal(
                    support.point_array(block, "SmoothedScalars"),
                    support.point_array(support.fetch(alone), "SmoothedScalars"),
                )
            )

    def test_a_state_keeps_the_choices(self):
        sphere = simple.Sphere(ThetaResolution=30, PhiResolution=30)
        height = simple.PointSetScalarFunction(Input=sphere, Function="Height")
        settings = {
            "Method": "LeastSquaresConstraints",
            "EpsilonChoice": "Manual",
            "Epsilon": 12345.0,
            "Constraints": "DeltaSimplified",
            "Delta": 0.001,
            "PersistenceThreshold": 0.25,
            "Weights": "MeanValue",
            "Metric": "LumpedMass",
            "Energy": "Harmonic",
            "IncludeOneStars": 0,
            "SmoothedStars": 0,
            "ResultArrayName": "smooth",
        }
        simple.ConstrainedSmoothing(
            registrationName="Smooth", Input=height, ScalarArray=["POINTS", "Height"],
            ConstraintArray=["POINTS", "Height"], **settings)
        path = support.output_file("smoothing.pvsm")
        servermanager.SaveState(path)
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)
        simple.LoadState(path)
        smoothing = simple.FindSource("Smooth")
        for name, value in settings.items():
            self.assertEqual(getattr(smoothing, name), value, name)
        self.assertEqual(list(smoothing.ScalarArray), ["POINTS", "Height"])
        self.assertEqual(list(smoothing.ConstraintArray), ["POINTS", "Height"])


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

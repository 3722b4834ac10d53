"""Design of functions through the plugin: from a filter's critical points, a table, points placed in the view."""

import os
import runpy
import sys
import unittest
from unittest import mock

import numpy
import support
from paraview import servermanager, simple
from vtk import vtkDoubleArray, vtkIntArray

# On the torus of support.torus_mesh() a height along x has a maximum, two saddles and a minimum at these points.
NATURAL = {0: 3, 12 * 48: 1, 12 * 48 + 24: 1, 24: 0}

MOVING_MAXIMUM = """
import numpy
import vtk
executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
time = information.Get(executive.UPDATE_TIME_STEP()) if information.Has(executive.UPDATE_TIME_STEP()) else 0.0
angle = 2 * numpy.pi * time / 48
output = self.GetOutput()
points = vtk.vtkPoints()
points.InsertNextPoint(1.4 * numpy.cos(angle), 1.4 * numpy.sin(angle), 0)
points.InsertNextPoint(-0.6, 0, 0)
output.SetPoints(points)
types = vtk.vtkDoubleArray()
types.SetName('CriticalType')
for kind in (3, 0):
    types.InsertNextValue(kind)
output.GetPointData().AddArray(types)
output.GetInformation().Set(output.DATA_TIME_STEP(), time)
"""


class TestDesign(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles = support.torus_mesh()
        cls.source = support.source(support.mesh(cls.points, cls.triangles))

    def tearDown(self):
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)

    def requests(self, types=NATURAL, **arrays):
        places = self.points[list(types)]
        return support.source(support.polydata(places, CriticalType=numpy.array(list(types.values())), **arrays))

    def design(self, points=None, **properties):
        inputs = {"CriticalPoints": points} if points else {}
        return simple.ScalarFunctionDesign(Input=self.source, **inputs, **properties)

    def expect_designed(self, design, types=NATURAL, silent=True):
        """The function is critical where it was asked to be, and says so."""
        with support.Messages() as messages:
            mesh, found = support.fetch(design), support.fetch(design, 1)
        if silent:
            self.assertEqual(messages.text, "")
        self.assertEqual(list(support.field_array(mesh, "Missing")), [0])
        ids = support.point_array(found, "PointId")
        prescribed = support.point_array(found, "Prescribed") == 1
        self.assertEqual(dict(zip(ids[prescribed], support.point_array(found, "CriticalType")[prescribed])), types)
        self.assertEqual(list(support.field_array(mesh, "Added")), [numpy.count_nonzero(~prescribed)])
        self.assertTrue(numpy.all(numpy.isfinite(support.point_array(mesh, "DesignedScalars"))))
        return mesh

    def test_field_data(self):
        design = self.design(self.requests())
        for port in (0, 1):
            for name, kind, count in (
                ("CriticalCounts", vtkIntArray, 3),
                ("EulerCharacteristic", vtkIntArray, 1),
                ("Missing", vtkIntArray, 1),
                ("Added", vtkIntArray, 1),
                ("Epsilon", vtkDoubleArray, 1),
            ):
                array = support.fetch(design, port).GetFieldData().GetArray(name)
                self.assertIsInstance(array, kind)
                self.assertEqual(array.GetNumberOfTuples(), count)
        self.assertEqual(list(support.field_array(support.fetch(design), "CriticalCounts")), [1, 2, 1])
        self.assertEqual(set(support.cell_array(support.fetch(design), "Split")), {0})

    def test_what_a_filter_found(self):
        """The critical points of a function, found on the mesh or on its points alone, are asked for again."""
        height = self.points @ (numpy.array([0.9, 0.2, 0.4]) / numpy.linalg.norm([0.9, 0.2, 0.4]))
        function = support.source(support.mesh(self.points, self.triangles, f=height))
        for find in (simple.MeshCriticalPoints, simple.FuzzyCriticalPoints):
            found = find(Input=function, ScalarArray=["POINTS", "f"])
            asked = support.fetch(found, 1)
            mesh = support.fetch(self.design(simple.OutputPort(found, 1)))
            self.assertEqual(list(support.field_array(mesh, "Missing")), [0])
            self.assertEqual(list(support.field_array(mesh, "CriticalCounts")), [1, 2, 1])
            places = support.positions(asked)
            nearest = numpy.linalg.norm(self.points[:, None] - places[None], axis=2).argmin(axis=0)
            values = support.point_array(mesh, "DesignedScalars")[nearest]
            self.assertLess(numpy.abs(values - support.point_array(asked, "ScalarValue")).max(), 1e-9)

    def test_points_of_a_table(self):
        path = support.output_file("critical-points.csv")
        with open(path, "w", encoding="utf-8") as file:
            file.write("x,y,z,CriticalType,ScalarValue\n")
            for point, kind in NATURAL.items():
                x, y, z = self.points[point]
                file.write(f"{x:.6f},{y:.6f},{z:.6f},{kind},{[-1, 0, 0, 1][kind]}\n")
        table = simple.CSVReader(FileName=[path])
        points = simple.TableToPoints(Input=table, XColumn="x", YColumn="y", ZColumn="z")
        mesh = self.expect_designed(self.design(points))
        values = support.point_array(mesh, "DesignedScalars")
        self.assertAlmostEqual(values[24], -1)
        self.assertAlmostEqual(values[0], 1)
        self.assertAlmostEqual(values[12 * 48], 0)

    def placed(self):
        """What a user places: Point Sources, whose centers are handles in the view, with types by Calculator."""
        sources, typed = {}, []
        for point, kind in NATURAL.items():
            sources[point] = simple.PointSource(Center=list(self.points[point] + [0.01, 0.01, 0]), Radius=0)
            typed.append(simple.Calculator(Input=sources[point], ResultArrayName="CriticalType", Function=str(kind)))
        return sources, typed

    def test_points_placed_in_the_view(self):
        _, typed = self.placed()
        for merge in (simple.AppendGeometry, simple.GroupDatasets):
            self.expect_designed(self.design(merge(Input=typed)))

    def test_a_moved_point(self):
        """What follows a moved point is what a new design gives."""
        sources, typed = self.placed()
        design = self.design(simple.GroupDatasets(Input=typed))
        self.expect_designed(design)
        for point in (3, 3 + 48, 5 + 2 * 48):
            sources[0].Center = list(self.points[point])
            types = {point: 3, **{other: kind for other, kind in NATURAL.items() if other}}
            moved = support.point_array(self.expect_designed(design, types), "DesignedScalars")
            fresh = self.expect_designed(self.design(self.requests(types)), types)
            self.assertLess(numpy.abs(moved - support.point_array(fresh, "DesignedScalars")).max(), 1e-9)

    def test_a_template(self):
        height = self.points @ (numpy.array([0.9, 0.2, 0.4]) / numpy.linalg.norm([0.9, 0.2, 0.4]))
        function = support.source(support.mesh(self.points, self.triangles, f=height))
        design = simple.ScalarFunctionDesign(Input=function)
        self.assertEqual(list(design.TemplateArray), ["POINTS", "None"])
        for array in ("f", ["POINTS", "f"]):
            design.TemplateArray = array
            mesh = support.fetch(design)
            self.assertEqual(list(support.field_array(mesh, "CriticalCounts")), [1, 2, 1])
            self.assertEqual(list(support.field_array(mesh, "Missing")), [0])
        design.CriticalPoints = self.requests()
        design.TemplateArray = ["POINTS", "None"]
        self.expect_designed(design)

    def test_a_saddle_of_high_multiplicity(self):
        """A monkey saddle fits its six neighbors; four mountains and valleys need more, so that triangles are split."""
        for multiplicity, count in ((2, 1152), (3, 1158)):
            types = {0: 3, 7 * 48 + 10: 1, 24: 0}
            design = self.design(self.requests(types, Multiplicity=numpy.array([1, multiplicity, 1])))
            mesh = self.expect_designed(design, types)
            self.assertEqual(mesh.GetNumberOfPoints(), count)
            found = support.fetch(design, 1)
            at = list(support.point_array(found, "PointId")).index(7 * 48 + 10)
            self.assertEqual(support.point_array(found, "Multiplicity")[at], multiplicity)
            self.assertEqual(numpy.count_nonzero(support.cell_array(mesh, "Split")), 0 if multiplicity == 2 else 24)

    def test_every_approach_gives_a_result(self):
        points = self.requests()
        for approach in ("MeshBased", "Meshless"):
            for constraints in ("Interpolating", "LeastSquares"):
                design = self.design(points, Approach=approach, ConstraintType=constraints)
                with support.Messages() as messages:
                    mesh = support.fetch(design)
                self.assertNotIn("ERROR", messages.text)
                self.assertTrue(numpy.all(numpy.isfinite(support.point_array(mesh, "DesignedScalars"))))
                rows = support.fetch(design, 2).GetNumberOfRows()
                self.assertEqual(rows > 0, constraints == "LeastSquares")

    def expect_refused(self, design, *words):
        with support.Messages() as messages:
            for port in (0, 1):
                self.assertEqual(support.fetch(design, port).GetNumberOfPoints(), 0)
            self.assertEqual(support.fetch(design, 2).GetNumberOfColumns(), 0)
        self.assertIn("Scalar Function Design: needs ", messages.text)
        for word in words:
            self.assertIn(word, messages.text)

    def test_refusals(self):
        self.expect_refused(self.design(), "CriticalPoints", "TemplateArray", "neither")
        self.expect_refused(self.design(self.requests({**NATURAL, 100: 7})), "found 7 at point 4 of CriticalPoints")
        self.expect_refused(self.design(simple.PointSource(Center=[1.4, 0, 0], Radius=0)), "'CriticalType'")
        far = support.source(support.polydata(numpy.array([[9.0, 0, 0]]), CriticalType=numpy.array([3])))
        self.expect_refused(self.design(far), "at a distance of 7.6")
        self.expect_refused(self.design(self.requests(), PersistenceThreshold=2), "PersistenceThreshold", "2")

    def test_the_critical_points_can_be_taken_away(self):
        design = self.design(self.requests())
        self.expect_designed(design)
        design.CriticalPoints = None
        self.expect_refused(design, "neither")

    def test_time_steps(self):
        """The maximum moves: each step is designed as if it were alone."""
        series = support.three_steps(MOVING_MAXIMUM)
        design = self.design(series)
        for time in (0.0, 1.0, 2.0, 0.0):
            design.UpdatePipeline(time)
            mesh = design.GetClientSideObject().GetOutputDataObject(0)
            values = support.point_array(mesh, "DesignedScalars")
            self.assertEqual(values.argmax(), int(time))
            alone = self.design(series)
            alone.UpdatePipeline(time)
            expected = alone.GetClientSideObject().GetOutputDataObject(0)
            difference = numpy.abs(values - support.point_array(expected, "DesignedScalars")).max()
            self.assertLess(difference, 1e-9)

    def test_a_block_is_a_mesh(self):
        group = simple.GroupDatasets(Input=[self.source])
        design = simple.ScalarFunctionDesign(Input=group, CriticalPoints=self.requests())
        block = support.fetch(design).NewIterator().GetCurrentDataObject()
        alone = support.fetch(self.design(self.requests()))
        self.assertTrue(
            numpy.array_equal(
                support.point_array(block, "DesignedScalars"), support.point_array(alone, "DesignedScalars")
            )
        )

    def test_a_state_keeps_the_choices(self):
        sphere = simple.Sphere(ThetaResolution=30, PhiResolution=30)
        height = simple.PointSetScalarFunction(Input=sphere, Function="Height")
        points = simple.Calculator(
            registrationName="Peak", Input=simple.PointSource(Radius=0), ResultArrayName="CriticalType", Function="3")
        settings = {
            "Approach": "Meshless",
            "ConstraintType": "LeastSquares",
            "CleanUp": 1,
            "EpsilonChoice": "Manual",
            "Epsilon": 12345.0,
            "Energy": "Harmonic",
            "Metric": "LumpedMass",
            "Kernel": "Wendland",
            "KernelWidth": 0.5,
            "MaximumDistance": 0.25,
            "PersistenceThreshold": 0.125,
            "ResultArrayName": "designed",
        }
        for name, template in (("Plain", ["POINTS", "None"]), ("Templated", ["POINTS", "Height"])):
            simple.ScalarFunctionDesign(
                registrationName=name, Input=height, CriticalPoints=points, TemplateArray=template, **settings)
        path = support.output_file("design.pvsm")
        servermanager.SaveState(path)
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)
        simple.LoadState(path)
        for registration, template in (("Plain", ["POINTS", "None"]), ("Templated", ["POINTS", "Height"])):
            design = simple.FindSource(registration)
            for name, value in settings.items():
                self.assertEqual(getattr(design, name), value, name)
            self.assertEqual(list(design.TemplateArray), template)
            self.assertEqual(design.CriticalPoints, simple.FindSource("Peak"))

    def test_the_example_and_its_state(self):
        """The state that the example writes can be worked with: the function follows a peak."""
        data = os.environ["SURFACE_SCALARS_DATA"]
        example = os.path.join(os.path.dirname(data), "Examples", "pvpython", "design_function.py")
        picture, state = support.output_file("design.png"), support.output_file("design-elephant.pvsm")
        arguments = [example, os.environ["SURFACE_SCALARS_PLUGIN"], os.path.join(data, "elephant.vtk"), picture]
        with mock.patch.object(sys, "argv", arguments + ["--state", state]):
            runpy.run_path(example, run_name="__main__")
        self.assertGreater(os.path.getsize(picture), 10000)
        simple.ResetSession()
        simple.LoadState(state)
        function, peak = simple.FindSource("function"), simple.FindSource("peak 1")
        for height in (0.5, 0.49):
            peak.Center = [0.184, height, 0.089]
            with support.Messages() as messages:
                mesh, found = support.fetch(function), support.fetch(function, 1)
            self.assertEqual(messages.text, "")
            self.assertEqual(list(support.field_array(mesh, "Missing")), [0])
            self.assertEqual(numpy.count_nonzero(support.point_array(found, "Prescribed")), 7)


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

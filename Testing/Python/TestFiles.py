"""What is saved is read back as it was: contours with DataMode Binary, pipelines as state files with their enumerations."""

import unittest

import numpy
import support
from paraview import servermanager, simple


def make_pipeline():
    """A dense sphere, its height, contours: all of it can be stored in a state file."""
    sphere = simple.Sphere(ThetaResolution=60, PhiResolution=60)
    height = simple.PointSetScalarFunction(
        registrationName="Heights", Input=sphere, Function="DistanceToPlane", Normal=[0, 0.6, 0.8]
    )
    return simple.PointSetContour(
        registrationName="Curves",
        Input=height,
        ScalarArray=["POINTS", "DistanceToPlane"],
        ContourValues=[-0.2, 0.1, 0.3],
        Scheme="ExplicitMLS",
        SurfaceModel="Unprojected",
        Fit="LeastSquares",
        PolynomialDegree=3,
        LinkDistance=4.5,
        Tolerance=1e-5,
    )


SETTINGS = ("ContourValues", "Scheme", "SurfaceModel", "Fit", "PolynomialDegree", "LinkDistance", "Tolerance")


def settings(contour):
    values = {}
    for name in SETTINGS:
        value = getattr(contour, name)
        values[name] = list(value) if name == "ContourValues" else value
    return values


class TestFiles(unittest.TestCase):
    def tearDown(self):
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)

    def test_contours_are_read_back_exactly(self):
        points = support.torus_points(4000)
        contour = simple.PointSetContour(
            Input=support.source(support.polydata(points, f=points[:, 2])), ContourValues=[-0.2, 0.1]
        )
        path = support.output_file("contours.vtp")
        simple.SaveData(path, proxy=contour, DataMode="Binary")

        written = support.fetch(contour)
        read = support.fetch(simple.XMLPolyDataReader(FileName=[path]))
        self.assertGreater(read.GetNumberOfCells(), 0)
        self.assertTrue(numpy.array_equal(support.positions(read), support.positions(written)))
        for name in ("f", "Normals", "Residual"):
            self.assertTrue(numpy.array_equal(support.point_array(read, name), support.point_array(written, name)))
        for name in ("IsoValue", "ComponentId", "Closed", "Length"):
            self.assertTrue(numpy.array_equal(support.cell_array(read, name), support.cell_array(written, name)))
        for name in ("IsoValues", "ComponentCounts"):
            self.assertTrue(numpy.array_equal(support.field_array(read, name), support.field_array(written, name)))
        for cell in range(written.GetNumberOfCells()):
            self.assertEqual(read.GetCell(cell).GetNumberOfPoints(), written.GetCell(cell).GetNumberOfPoints())

    def test_state_files_bring_the_pipeline_back(self):
        contour = make_pipeline()
        before = settings(contour)
        points = support.positions(support.fetch(contour)).copy()
        path = support.output_file("state.pvsm")
        servermanager.SaveState(path)
        self.tearDown()

        servermanager.LoadState(path)
        loaded = simple.FindSource("Curves")
        self.assertIsNotNone(loaded)
        self.assertEqual(settings(loaded), before)
        self.assertEqual(simple.FindSource("Heights").Function, "DistanceToPlane")
        self.assertEqual(list(loaded.ScalarArray), ["POINTS", "DistanceToPlane"])
        self.assertTrue(numpy.array_equal(support.positions(support.fetch(loaded)), points))

    def test_state_files_keep_the_integers(self):
        make_pipeline()
        path = support.output_file("state-integers.pvsm")
        servermanager.SaveState(path)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        for name, code in (("Scheme", 1), ("SurfaceModel", 2), ("Fit", 1), ("Function", 2)):
            stored = text.split(f'<Property name="{name}"', 1)[1].split("</Property>", 1)[0]
            self.assertIn(f'<Element index="0" value="{code}"/>', stored)

    def test_state_files_keep_the_cut(self):
        contour = make_pipeline()
        contour.CutFunction = "Sphere"
        contour.CutFunction.Center = [0.5, 0, 0]
        contour.CutFunction.Radius = 0.6
        contour.ContourValues = [0]
        points = support.positions(support.fetch(contour)).copy()
        self.assertGreater(len(points), 0)
        path = support.output_file("state-cut.pvsm")
        servermanager.SaveState(path)
        self.tearDown()

        servermanager.LoadState(path)
        loaded = simple.FindSource("Curves")
        self.assertEqual(loaded.CutFunction.Radius, 0.6)
        self.assertTrue(numpy.array_equal(support.positions(support.fetch(loaded)), points))

    def test_critical_points_are_read_back_exactly(self):
        points = support.torus_points(4000)
        source = support.source(support.polydata(points, f=points[:, 0]))
        critical = simple.FuzzyCriticalPoints(Input=source, ScalarArray=["POINTS", "f"])
        for port, names in (
            (0, ("f", "CriticalProbability", "Gradient", "Normals", "CriticalType")),
            (1, ("CriticalType", "Multiplicity", "CriticalProbability", "ScalarValue", "PointId", "Persistence")),
        ):
            path = support.output_file(f"critical-{port}.vtp")
            simple.SaveData(path, proxy=simple.OutputPort(critical, port), DataMode="Binary")
            written = support.fetch(critical, port)
            read = support.fetch(simple.XMLPolyDataReader(FileName=[path]))
            self.assertGreater(read.GetNumberOfPoints(), 0)
            self.assertTrue(numpy.array_equal(support.positions(read), support.positions(written)))
            for name in names:
                self.assertTrue(numpy.array_equal(support.point_array(read, name), support.point_array(written, name)))
            self.assertEqual(support.field_array(read, "IndexSum"), support.field_array(written, "IndexSum"))

    def test_state_files_bring_functions_and_critical_points_back(self):
        sphere = simple.Sphere(ThetaResolution=40, PhiResolution=40)
        function = simple.PointSetScalarFunction(
            registrationName="Harmonic",
            Input=sphere,
            Function="Harmonic",
            ConstraintIds=[0, 1, 700],
            ConstraintValues=[0, 1, 0.5],
            NeighborCount=12,
        )
        critical = simple.FuzzyCriticalPoints(
            registrationName="Critical", Input=function, ScalarArray=["POINTS", "Harmonic"], PersistenceThreshold=0.02
        )
        values = support.point_array(support.fetch(function), "Harmonic").copy()
        places = support.positions(support.fetch(critical, 1)).copy()
        path = support.output_file("state-critical.pvsm")
        servermanager.SaveState(path)
        self.tearDown()

        servermanager.LoadState(path)
        loaded = simple.FindSource("Harmonic")
        self.assertEqual(loaded.Function, "Harmonic")
        self.assertEqual(list(loaded.ConstraintIds), [0, 1, 700])
        self.assertEqual(list(loaded.ConstraintValues), [0, 1, 0.5])
        self.assertTrue(numpy.array_equal(support.point_array(support.fetch(loaded), "Harmonic"), values))
        critical = simple.FindSource("Critical")
        self.assertEqual(critical.PersistenceThreshold, 0.02)
        self.assertTrue(numpy.array_equal(support.positions(support.fetch(critical, 1)), places))


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

"""Curves of a model on meshes through the plugin: a coarse mesh, a file, blocks, time, what follows downstream."""

import unittest

import numpy
import support
from paraview import servermanager, simple
from vtk import vtkDoubleArray, vtkIntArray

# A grid in the plane that is moved along x as time goes on.
MOVING_GRID = """
import vtk
executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
time = information.Get(executive.UPDATE_TIME_STEP()) if information.Has(executive.UPDATE_TIME_STEP()) else 0.0
plane = vtk.vtkPlaneSource()
plane.SetOrigin(-1 + 0.1 * time, -1, 0)
plane.SetPoint1(1 + 0.1 * time, -1, 0)
plane.SetPoint2(-1 + 0.1 * time, 1, 0)
plane.SetResolution(6, 6)
plane.Update()
output = self.GetOutput()
output.ShallowCopy(plane.GetOutput())
output.GetInformation().Set(output.DATA_TIME_STEP(), time)
"""


def distance(points):
    return numpy.linalg.norm(points, axis=1)


class TestMeshlessContour(unittest.TestCase):
    def setUp(self):
        points = numpy.random.RandomState(1).uniform(-1.5, 1.5, (500, 3))
        samples = support.source(support.polydata(points, f=distance(points) ** 2))
        self.extend = simple.RBFExtend(Input=samples, Scheme="GlobalRBF", GridDimensions=[2, 2, 2])
        self.model = servermanager.OutputPort(self.extend, 1)
        self.plane = simple.Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0], XResolution=5, YResolution=5)

    def tearDown(self):
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)

    def contour(self, surface=None, **properties):
        return simple.MeshlessContour(
            Input=self.model, Surface=surface or self.plane, **{"ContourValues": [0.25, 0.5], **properties}
        )

    def expect_circles(self, output, values=(0.25, 0.5)):
        self.assertEqual(list(support.cell_array(output, "IsoValue")), list(values))
        self.assertEqual(set(support.cell_array(output, "Closed")), {1})
        lengths = 2 * numpy.pi * numpy.sqrt(values)
        self.assertLess(numpy.abs(support.cell_array(output, "Length") / lengths - 1).max(), 0.02)
        error = distance(support.positions(output)) ** 2 - support.point_array(output, "f")
        self.assertLess(numpy.abs(error).max(), 0.02)

    def test_quads_of_a_coarse_mesh(self):
        with support.Messages() as messages:
            output = support.fetch(self.contour())
        self.assertEqual(messages.text, "")
        self.expect_circles(output)
        self.assertGreater(output.GetNumberOfPoints(), 100)
        for data, name, kind in (
            (output.GetCellData(), "IsoValue", vtkDoubleArray),
            (output.GetCellData(), "ComponentId", vtkIntArray),
            (output.GetCellData(), "Closed", vtkIntArray),
            (output.GetCellData(), "Length", vtkDoubleArray),
            (output.GetPointData(), "f", vtkDoubleArray),
            (output.GetPointData(), "Normals", vtkDoubleArray),
            (output.GetFieldData(), "IsoValues", vtkDoubleArray),
            (output.GetFieldData(), "ComponentCounts", vtkIntArray),
            (output.GetFieldData(), "LargestDeviation", vtkDoubleArray),
            (output.GetFieldData(), "EvaluatedShare", vtkDoubleArray),
        ):
            self.assertIsInstance(data.GetArray(name), kind, name)

    def test_without_values_the_middle_of_the_range(self):
        values = support.point_array(support.fetch(self.extend.Input), "f")
        output = support.fetch(self.contour(ContourValues=[]))
        middle = 0.5 * (values.min() + values.max())
        self.assertAlmostEqual(support.field_array(output, "IsoValues")[0], middle)

    def test_a_model_of_a_file(self):
        path = support.output_file("meshless-contour-model.vtp")
        simple.SaveData(path, proxy=self.model, DataMode="Binary")
        expected = support.positions(support.fetch(self.contour()))
        self.model = simple.XMLPolyDataReader(FileName=[path])
        self.assertTrue(numpy.array_equal(support.positions(support.fetch(self.contour())), expected))

    def test_blocks_of_a_surface(self):
        beside = simple.Transform(Input=self.plane)
        beside.Transform.Translate = [0, 0, 0.1]
        group = simple.GroupDatasets(Input=[self.plane, beside])
        output = support.fetch(self.contour(group, ContourValues=[0.5]))
        self.assertTrue(output.IsA("vtkCompositeDataSet"))
        self.assertEqual(output.GetNumberOfCells(), 2)

    def test_a_surface_that_moves(self):
        series = support.three_steps(MOVING_GRID)
        contour = self.contour(series, ContourValues=[0.36])
        for time in (0.0, 1.0, 2.0, 0.0):
            contour.UpdatePipeline(time)
            output = contour.GetClientSideObject().GetOutputDataObject(0)
            self.expect_circles(output, [0.36])

    def test_what_follows_downstream(self):
        tube = simple.Tube(Input=self.contour(), Radius=0.01)
        self.assertGreater(support.fetch(tube).GetNumberOfPoints(), 1000)

    def test_what_is_no_model_is_refused(self):
        self.model = self.plane
        with support.Messages() as messages:
            output = support.fetch(self.contour())
        self.assertIn("Meshless Contour: needs a Model", messages.text)
        self.assertEqual(output.GetNumberOfPoints(), 0)


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

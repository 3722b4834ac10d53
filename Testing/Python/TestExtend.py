"""Functions extended through the plugin: grids, targets, models on disk, time series, what follows downstream."""

import unittest

import numpy
import support
from paraview import servermanager, simple
from vtk import vtkStreamingDemandDrivenPipeline


def wave(points):
    return numpy.sin(points[:, 0]) + 0.5 * points[:, 1] * points[:, 2]


def samples(count=600, seed=1):
    """Random samples of wave() in a cube, with an array f."""
    points = numpy.random.RandomState(seed).uniform(-1, 1, (count, 3))
    return support.source(support.polydata(points, f=wave(points)))


def targets(count=50, seed=2):
    return support.source(support.polydata(numpy.random.RandomState(seed).uniform(-0.8, 0.8, (count, 3))))


ARRAYS = ("f", "fGradient", "fHessian", "Valid")


class TestExtend(unittest.TestCase):
    def expect_same(self, one, other):
        for name in ARRAYS:
            self.assertTrue(
                numpy.array_equal(support.point_array(one, name), support.point_array(other, name)), name
            )

    def test_a_uniform_grid_without_a_target(self):
        extend = simple.RBFExtend(Input=samples(), GridDimensions=[12, 14, 16], GridPadding=0.1)
        grid = support.fetch(extend)
        self.assertEqual(grid.GetClassName(), "vtkImageData")
        self.assertEqual(grid.GetDimensions(), (12, 14, 16))
        self.assertEqual(grid.GetPointData().GetScalars().GetName(), "f")
        self.assertLess(grid.GetBounds()[0], -1.15)
        places = numpy.array([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())])
        inside = numpy.abs(places).max(axis=1) < 0.8
        error = support.point_array(grid, "f") - wave(places)
        self.assertLess(numpy.abs(error[inside]).max(), 0.02)

    def test_samples_on_an_image(self):
        coarse = simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])
        same = simple.RBFExtend(Input=coarse, Target=coarse)
        values = support.point_array(support.fetch(same), "RTData")
        samples_there = support.point_array(support.fetch(same), "RTDataInput")
        self.assertLess(numpy.abs(values - samples_there).max(), 1e-3)

    def test_contour_slice_and_picture_of_the_grid(self):
        extend = simple.RBFExtend(Input=samples(), GridDimensions=[12, 12, 12])
        contour = simple.Contour(Input=extend, ContourBy=["POINTS", "f"], Isosurfaces=[0.2])
        self.assertGreater(support.fetch(contour).GetNumberOfCells(), 50)
        cut = simple.Slice(Input=extend, SliceType="Plane")
        cut.SliceType.Origin = [0, 0, 0]
        self.assertGreaterEqual(support.fetch(cut).GetNumberOfPoints(), 100)
        subset = simple.ExtractSubset(Input=extend, VOI=[2, 5, 2, 5, 3, 3])
        self.assertEqual(support.fetch(subset).GetNumberOfPoints(), 16)
        self.assertTrue(
            set(support.point_array(support.fetch(subset), "f")) < set(support.point_array(support.fetch(extend), "f"))
        )
        view = simple.CreateView("RenderView")
        display = simple.Show(extend, view)
        display.SetRepresentationType("Volume")
        simple.ColorBy(display, ("POINTS", "f"))
        with support.Messages() as messages:
            simple.Render(view)
        self.assertNotIn("ERR", messages.text)
        simple.Delete(view)

    def test_a_target_is_set_and_cleared(self):
        extend = simple.RBFExtend(Input=samples(), GridDimensions=[4, 4, 4])
        self.assertEqual(support.fetch(extend).GetClassName(), "vtkImageData")
        extend.Target = targets()
        self.assertEqual(support.fetch(extend).GetClassName(), "vtkPolyData")
        self.assertEqual(support.fetch(extend).GetNumberOfPoints(), 50)
        extend.Target = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])
        self.assertEqual(support.fetch(extend).GetClassName(), "vtkImageData")
        self.assertEqual(support.fetch(extend).GetNumberOfPoints(), 125)
        self.assertIsNotNone(support.fetch(extend).GetPointData().GetArray("RTData"))
        extend.Target = None
        self.assertEqual(support.fetch(extend).GetClassName(), "vtkImageData")
        self.assertEqual(support.fetch(extend).GetNumberOfPoints(), 64)
        extend.Target = simple.GroupDatasets(Input=[targets(10), targets(20)])
        self.assertTrue(support.fetch(extend).IsA("vtkCompositeDataSet"))
        self.assertEqual(support.fetch(extend).GetNumberOfPoints(), 30)

    def test_a_target_without_an_f_beside_samples_that_have_one(self):
        extend = simple.RBFExtend(Input=samples(), Target=targets(), ScalarArray=["POINTS", "f"])
        output = support.fetch(extend)
        error = support.point_array(output, "f") - wave(support.positions(output))
        self.assertLess(numpy.abs(error).max(), 0.02)

    def test_a_model_read_back_evaluates_to_the_same_bits(self):
        for scheme in ("ExplicitMLS", "ParameterizedMLS", "LocalRBF", "Hybrid", "GlobalRBF"):
            target = targets()
            extend = simple.RBFExtend(
                Input=samples(), Target=target, Scheme=scheme, ComputeGradient=1, ComputeHessian=1
            )
            expected = support.fetch(extend)
            path = support.output_file("model.vtp")
            simple.SaveData(path, proxy=servermanager.OutputPort(extend, 1), DataMode="Binary")
            evaluate = simple.RBFEvaluate(
                Input=simple.XMLPolyDataReader(FileName=[path]), Target=target, ComputeGradient=1, ComputeHessian=1
            )
            self.expect_same(support.fetch(evaluate), expected)

    def test_a_model_in_memory(self):
        target = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])
        extend = simple.RBFExtend(Input=samples(), Target=target, ComputeGradient=1, ComputeHessian=1)
        evaluate = simple.RBFEvaluate(
            Input=servermanager.OutputPort(extend, 1), Target=target, ComputeGradient=1, ComputeHessian=1
        )
        self.expect_same(support.fetch(evaluate), support.fetch(extend))
        slice_of_it = simple.Slice(Input=evaluate)
        self.assertGreater(support.fetch(slice_of_it).GetNumberOfPoints(), 0)

    def test_what_is_no_model_is_refused(self):
        with support.Messages() as messages:
            output = support.fetch(simple.RBFEvaluate(Input=samples(), Target=targets()))
        self.assertIn("RBF Evaluate: needs a Model", messages.text)
        self.assertEqual(output.GetNumberOfPoints(), 0)

    def test_results_by_name(self):
        extend = simple.RBFExtend(
            Input=samples(),
            Target=targets(),
            Kernel="Wendland",
            KernelWidth=1.5,
            NeighborCount=40,
            ClampToRange=1,
            MaximumDistance=0.01,
            NullValue=-5,
            ResultArrayName="height",
        )
        output = support.fetch(extend)
        valid = support.point_array(output, "Valid")
        self.assertTrue(numpy.all(support.point_array(output, "height")[valid == 0] == -5))
        self.assertGreater(numpy.sum(valid == 0), 0)

    def test_an_osculating_paraboloid(self):
        for scheme in ("ExplicitMLS", "LocalRBF", "GlobalRBF"):
            paraboloid = simple.OsculatingParaboloid(Input=samples(1000), PointId=7, Scheme=scheme)
            surface = support.fetch(paraboloid)
            self.assertGreater(surface.GetNumberOfPolys(), 100)
            self.assertEqual(len(set(support.point_array(surface, "f"))), 1)
            normals = support.point_array(surface, "Normals")
            self.assertTrue(numpy.allclose(numpy.linalg.norm(normals, axis=1), 1))


SERIES = """
import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk

executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
time = 0.0
if information.Has(executive.UPDATE_TIME_STEP()):
    time = information.Get(executive.UPDATE_TIME_STEP())
points = numpy.random.RandomState(3).uniform(-1, 1, (400, 3))
output = self.GetOutput()
output.SetPoints(vtk.vtkPoints())
output.GetPoints().SetData(numpy_to_vtk(points, deep=True))
values = numpy_to_vtk(numpy.sin(points[:, 0] + time), deep=True)
values.SetName('f')
output.GetPointData().SetScalars(values)
output.GetInformation().Set(output.DATA_TIME_STEP(), time)
"""

def steps_of(proxy):
    proxy.UpdatePipelineInformation()
    return list(proxy.GetClientSideObject().GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()))


class TestExtendTime(unittest.TestCase):
    def test_each_step_is_what_a_new_filter_gives(self):
        series = support.three_steps(SERIES)
        extend = simple.RBFExtend(Input=series, Target=targets())
        self.assertEqual(steps_of(extend), [0.0, 1.0, 2.0])
        for time in (0.0, 1.0, 2.0, 0.0):
            extend.UpdatePipeline(time)
            fresh = simple.RBFExtend(Input=series, Target=targets())
            fresh.UpdatePipeline(time)
            one, other = (proxy.GetClientSideObject().GetOutputDataObject(0) for proxy in (extend, fresh))
            values = support.point_array(one, "f")
            self.assertTrue(numpy.array_equal(values, support.point_array(other, "f")))
            self.assertLess(numpy.abs(values - numpy.sin(support.positions(one)[:, 0] + time)).max(), 0.02)

    def test_a_target_that_moves(self):
        """The time steps of the target reach downstream where the samples have none."""
        series = support.three_steps(SERIES)
        extend = simple.RBFExtend(Input=samples(), Target=series)
        self.assertEqual(steps_of(extend), [0.0, 1.0, 2.0])


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

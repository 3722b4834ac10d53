"""Functions approximated through the plugin: surfaces, images, models on disk, what follows downstream, time series."""

import unittest

import numpy
import support
from paraview import simple


def torus(**arrays):
    points, triangles = support.torus_mesh()
    x, y, _ = points.T
    f = points @ numpy.array([0.9, 0.2, 0.4]) + 0.2 * numpy.sin(3 * x + 1) * numpy.cos(2 * y)
    return support.source(support.mesh(points, triangles, f=f, **arrays))


def figure(dataset, name):
    return dataset.GetFieldData().GetArray(name).GetTuple1(0)


class TestApproximation(unittest.TestCase):
    def tearDown(self):
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)

    def approximate(self, source, **properties):
        return simple.MeshlessApproximation(Input=source, SampleFraction=0.3, **properties)

    def test_a_surface(self):
        approximation = self.approximate(torus(), ScalarArray=["POINTS", "f"])
        with support.Messages() as messages:
            result = support.fetch(approximation)
        self.assertEqual(messages.text or "", "")
        self.assertEqual(result.GetClassName(), "vtkPolyData")
        f, u = support.point_array(result, "f"), support.point_array(result, "fApproximation")
        self.assertTrue(numpy.array_equal(support.point_array(result, "ApproximationError"), f - u))
        self.assertEqual(figure(result, "LInfinityError"), numpy.abs(f - u).max())
        self.assertEqual(figure(result, "Missing"), 0)
        critical = support.fetch(approximation, 2)
        expected = simple.MeshCriticalPoints(Input=approximation, ScalarArray=["POINTS", "f"])
        ids = support.point_array(support.fetch(expected, 1), "PointId")
        prescribed = support.point_array(critical, "Prescribed") == 1
        self.assertEqual(set(ids), set(support.point_array(critical, "PointId")[prescribed]))

    def test_an_image(self):
        wavelet = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6], XFreq=4, YFreq=3, ZFreq=3)
        approximation = self.approximate(wavelet, PersistenceThreshold=0.1)
        result = support.fetch(approximation)
        self.assertEqual(result.GetClassName(), "vtkImageData")
        f, u = support.point_array(result, "RTData"), support.point_array(result, "RTDataApproximation")
        self.assertLess(numpy.abs(f - u).max(), 0.05 * (f.max() - f.min()))
        self.assertEqual(figure(result, "ScalarBytes"), 4 * 13**3)
        contour = simple.Contour(
            Input=approximation, ContourBy=["POINTS", "RTDataApproximation"], Isosurfaces=[float(numpy.median(u))]
        )
        self.assertGreater(support.fetch(contour).GetNumberOfCells(), 50)

    def test_a_model_on_disk(self):
        source = torus()
        approximation = self.approximate(source)
        model = simple.OutputPort(approximation, 1)
        file = support.output_file("approximation.vtp")
        simple.SaveData(file, model, DataMode="Binary")
        read = simple.XMLPolyDataReader(FileName=[file])
        direct = support.fetch(simple.RBFEvaluate(Input=model, Target=source, ResultArrayName="u"))
        later = support.fetch(simple.RBFEvaluate(Input=read, Target=source, ResultArrayName="u"))
        self.assertTrue(numpy.array_equal(support.point_array(direct, "u"), support.point_array(later, "u")))
        u = support.point_array(support.fetch(approximation), "fApproximation")
        self.assertLess(numpy.abs(support.point_array(direct, "u") - u).max(), 1e-12)

    def test_part_of_an_image_is_approximated_as_a_whole(self):
        wavelet = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5], XFreq=4, YFreq=3, ZFreq=3)
        approximation = self.approximate(wavelet, PersistenceThreshold=0.1)
        part = simple.ExtractSubset(Input=approximation, VOI=[0, 2, 0, 2, 0, 2])
        whole = set(support.point_array(support.fetch(approximation), "RTDataApproximation"))
        self.assertLessEqual(set(support.point_array(support.fetch(part), "RTDataApproximation")), whole)

    def test_errors_are_sentences(self):
        approximation = self.approximate(torus(), Kernel="Gaussian", KernelWidth=50)
        with support.Messages() as messages:
            approximation.UpdatePipeline()
        self.assertIn("Meshless Approximation: needs", messages.text)
        self.assertIn("condition", messages.text)


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()

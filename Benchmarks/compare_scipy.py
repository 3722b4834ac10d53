"""Times LocalRBF beside scipy's RBFInterpolator on the same samples and targets, one thread each, and prints the ratio.

usage: OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 pvpython compare_scipy.py PLUGIN

Needs python3-scipy. 100,000 random samples of a torus, 32 neighbors, cubic kernel, linear polynomial. The time of the
filter includes everything it does; scipy's includes building its tree. Medians of interleaved repetitions.
"""

import statistics
import sys
import time

import numpy
import vtk
from paraview import simple
from scipy.interpolate import RBFInterpolator
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

REPETITIONS = 3
SAMPLES = 100_000
TARGETS = 100_000
SCIPY_TARGETS = 10_000  # its time is proportional to their number


def torus(count, seed):
    generator = numpy.random.default_rng(seed)
    u, v, keep = generator.uniform(size=(3, 3 * count))
    u, v = 2 * numpy.pi * u, 2 * numpy.pi * v
    chosen = numpy.flatnonzero(1.4 * keep <= 1 + 0.4 * numpy.cos(v))[:count]
    u, v = u[chosen], v[chosen]
    return numpy.column_stack([(1 + 0.4 * numpy.cos(v)) * numpy.cos(u), (1 + 0.4 * numpy.cos(v)) * numpy.sin(u), 0.4 * numpy.sin(v)])


def polydata(points, values=None):
    data = vtk.vtkPolyData()
    data.SetPoints(vtk.vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    if values is not None:
        array = numpy_to_vtk(values, deep=True)
        array.SetName("f")
        data.GetPointData().SetScalars(array)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def seconds(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def main():
    simple.LoadPlugin(sys.argv[1], remote=False, ns=vars(simple))
    samples, targets = torus(SAMPLES, 1), torus(TARGETS, 2)
    values = samples[:, 0] ** 2 - samples[:, 1] ** 2 + numpy.log(1 + numpy.linalg.norm(samples, axis=1))
    known, wanted = polydata(samples, values), polydata(targets)

    def ours(threads):
        extended = simple.RBFExtend(Input=known, Target=wanted, Scheme="LocalRBF", Kernel="Cubic", NeighborCount=32)
        vtk.vtkSMPTools.Initialize(threads)
        return TARGETS / seconds(extended.UpdatePipeline)

    def theirs():
        return SCIPY_TARGETS / seconds(
            lambda: RBFInterpolator(samples, values, neighbors=32, kernel="cubic", degree=1)(targets[:SCIPY_TARGETS]))

    rates = [(ours(1), ours(2), theirs()) for _ in range(REPETITIONS)]
    one, two, scipy = (statistics.median(column) for column in zip(*rates))
    print(f"targets per second: LocalRBF {one:.0f} (1 thread), {two:.0f} (2 threads); scipy {scipy:.0f}")
    print(f"LocalRBF / scipy: {one / scipy:.1f}; 2 threads / 1 thread: {two / one:.2f}")


main()

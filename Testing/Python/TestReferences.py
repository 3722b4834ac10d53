"""Extending a function off its samples gives what well-known libraries give where they do the same."""

import numpy
from paraview import simple
from scipy.interpolate import RBFInterpolator

import support

support.load_plugin()


def check_local_rbf_equals_scipy():
    """Both interpolate by cubic kernels and a linear polynomial at the 32 nearest samples of each target."""
    samples = support.torus_points(4000, seed=1)
    targets = support.torus_points(500, seed=2) * 1.01  # a little off the surface
    values = samples[:, 0] ** 2 - samples[:, 1] ** 2 + numpy.log(1 + numpy.linalg.norm(samples, axis=1))
    extended = simple.RBFExtend(
        Input=support.source(support.polydata(samples, f=values)), ScalarArray=["POINTS", "f"],
        Target=support.source(support.polydata(targets)), Scheme="LocalRBF", Kernel="Cubic", NeighborCount=32)
    ours = support.point_array(support.fetch(extended), "f")
    theirs = RBFInterpolator(samples, values, neighbors=32, kernel="cubic", degree=1)(targets)
    difference = abs(ours - theirs).max() / numpy.ptp(values)
    assert difference < 1e-8, f"expected scipy's values within 1e-8 of the range, found {difference}"


def check_global_rbf_equals_scipy():
    """The same at all samples, for the kernels that both have (scipy's do not depend on a width either)."""
    samples = support.torus_points(400, seed=3)
    targets = support.torus_points(200, seed=4)
    values = numpy.sin(3 * samples[:, 0]) + samples[:, 1] * samples[:, 2]
    for ours_name, theirs_name in [("Cubic", "cubic"), ("ThinPlate", "thin_plate_spline"), ("Linear", "linear")]:
        extended = simple.RBFExtend(
            Input=support.source(support.polydata(samples, f=values)), ScalarArray=["POINTS", "f"],
            Target=support.source(support.polydata(targets)), Scheme="GlobalRBF", Kernel=ours_name)
        ours = support.point_array(support.fetch(extended), "f")
        theirs = RBFInterpolator(samples, values, kernel=theirs_name, degree=1)(targets)
        difference = abs(ours - theirs).max() / numpy.ptp(values)
        assert difference < 1e-8, f"{ours_name}: expected scipy's values within 1e-8 of the range, found {difference}"


check_local_rbf_equals_scipy()
check_global_rbf_equals_scipy()

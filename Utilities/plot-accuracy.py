"""Plots what Documentation/accuracy-extension.md tabulates, and the errors of the averages (6) on a scan in increasing order.

usage: pvpython plot-accuracy.py ACCURACY-EXTENSION.md CONVERGENCE.png [PLUGIN lion.vtp SORTED-ERRORS.png]
       python3 plot-accuracy.py CURVE.csv CALIBRATION.png

Needs python3-matplotlib. The first picture comes from the page's table alone. The second repeats Fig. 7 of the point-set
paper with the distance from a corner of the scan's bounding box as f. The third shows what
`surface-scalars-critical-truth calibration curve CURVE.csv` wrote: how often CriticalProbability is at most what it states.
"""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot
import numpy


def convergence(page):
    """{scheme: (numbers of samples, errors)} of the page's first table whose first column is `scheme`."""
    lines = open(page, encoding="utf-8").read().splitlines()
    start = next(i for i, line in enumerate(lines) if line.replace(" ", "").startswith("|scheme|100|"))
    head = [cell.strip() for cell in lines[start].strip("|").split("|")]
    counts = [int(cell) for cell in head[1:] if cell.isdigit()]
    curves = {}
    for line in lines[start + 2:]:
        if not line.startswith("|"):
            break
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        curves[cells[0]] = [(n, float(cell)) for n, cell in zip(counts, cells[1:]) if cell]
    return curves


def plot_convergence(curves, picture):
    figure, axes = pyplot.subplots(figsize=(8, 5.5))
    for name, points in curves.items():
        axes.loglog(*zip(*points), marker="o", markersize=4, label=name)
    for order, height in [(1, 0.3), (2, 4e-3), (3, 6e-4), (5, 2e-5)]:
        counts = numpy.array([1e4, 1e5])
        values = height / 10 * (counts / counts[0]) ** (-order / 2)
        axes.loglog(counts, values, color="gray", linestyle=":", linewidth=1)
        axes.annotate(f"order {order}", (counts[1], values[1]), fontsize=8, color="gray")
    axes.set_xlabel("samples of the torus")
    axes.set_ylabel("root mean square error between the samples / range of f")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


def sorted_errors(plugin, scan):
    """{scheme: errors at the samples in increasing order, as fractions of f's range}"""
    from paraview import simple
    from vtk.util.numpy_support import vtk_to_numpy

    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    lion = simple.XMLPolyDataReader(FileName=[scan])
    bounds = lion.GetDataInformation().GetBounds()
    distance = simple.PointSetScalarFunction(Input=lion, Function="DistanceToPoint", Center=bounds[0::2])
    f = vtk_to_numpy(simple.servermanager.Fetch(distance).GetPointData().GetArray("DistanceToPoint"))
    curves = {}
    for scheme in ["ExplicitMLS", "ParameterizedMLS"]:
        extended = simple.RBFExtend(Input=distance, ScalarArray=["POINTS", "DistanceToPoint"], Target=lion,
                                    Scheme=scheme, ResultArrayName="F")
        values = vtk_to_numpy(simple.servermanager.Fetch(extended).GetPointData().GetArray("F"))
        curves[scheme] = numpy.sort(abs(values - f)) / numpy.ptp(f)
    return curves


def plot_sorted(curves, picture):
    figure, axes = pyplot.subplots(figsize=(8, 4.5))
    for name, errors in curves.items():
        axes.semilogy(numpy.linspace(0, 1, len(errors)), numpy.maximum(errors, 1e-12), label=name)
        print(f"{name}: median {numpy.median(errors):.2e}, 99% {numpy.quantile(errors, 0.99):.2e}, largest {errors[-1]:.2e}")
    axes.set_xlabel("samples in order of their error, as a fraction of all")
    axes.set_ylabel("|F - f| / range of f")
    axes.grid(alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


def calibration(table):
    """{place: {samples: (stated, observed)}} from columns named "function; noise; place"."""
    with open(table, encoding="utf-8") as lines:
        rows = list(csv.reader(lines))
    numbers = numpy.array(rows[1:], dtype=float)
    curves = {}
    for column, name in enumerate(rows[0][1:], start=1):
        samples, place = name.rsplit("; ", 1)
        curves.setdefault(place, {})[samples] = (numbers[:, 0], numbers[:, column])
    return curves


def plot_calibration(places, picture):
    names = [samples.split("; ") for curves in places.values() for samples in curves]
    style_of = dict(zip(dict.fromkeys(function for function, _ in names), ["-", "--", ":"]))
    color_of = {noise: f"C{i}" for i, noise in enumerate(dict.fromkeys(noise for _, noise in names))}
    figure, all_axes = pyplot.subplots(1, len(places), figsize=(11, 5.2), sharey=True)
    for axes, (place, curves) in zip(all_axes, places.items()):
        axes.plot([0, 1], [0, 1], color="gray", linestyle=":", linewidth=1)
        for samples, curve in curves.items():
            function, noise = samples.split("; ")
            style = dict(color=color_of[noise], linestyle=style_of[function])
            axes.plot(*curve, label=samples, **style)
        axes.set_title(place)
        axes.set_xlabel("stated probability p")
        axes.grid(alpha=0.3)
    all_axes[0].set_ylabel("share of samples with CriticalProbability ≤ p")
    figure.tight_layout(rect=(0, 0.14, 1, 1))
    figure.legend(*all_axes[-1].get_legend_handles_labels(), loc="lower center", ncol=4, fontsize=8)
    figure.savefig(picture, dpi=110)


def main():
    if len(sys.argv) not in (3, 6):
        sys.exit(__doc__)
    if sys.argv[1].endswith(".csv"):
        plot_calibration(calibration(sys.argv[1]), sys.argv[2])
        return
    plot_convergence(convergence(sys.argv[1]), sys.argv[2])
    if len(sys.argv) == 6:
        plot_sorted(sorted_errors(*sys.argv[3:5]), sys.argv[5])


main()

"""Enlarges two test images from a half and a quarter of their size, and tells how well: Table 6 of the design paper.

usage: pvpython super_resolution.py PLUGIN DATA_FOLDER PICTURE.png [IMAGE...]

PLUGIN is SurfaceScalars.so; DATA_FOLDER holds camera.png and ascent.pgm (Utilities/fetch-data.sh), or the grayscale images
that are named. An image is reduced in two ways: to every 2nd or 4th pixel of every 2nd or 4th row, and to averages of 2 x 2
or 4 x 4 pixels. Small pixels are put where they are: at the pixel that was taken, or at the middle of those averaged.
LocalRBF enlarges with Hardy's kernel (Multiquadric) and with Gauss's. The width of the kernel is chosen from the small image
alone: that image is reduced once more in the same way, and the width that restores it best is taken; of the two kernels the
better one is marked in the same way. Splines and radial functions both see the image mirrored at its border.
"""

import os
import sys

import numpy
import vtk
from paraview.simple import *
from scipy import ndimage
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

if len(sys.argv) < 4:
    sys.exit(__doc__)
plugin, data, picture = sys.argv[1:4]
LoadPlugin(plugin, remote=False, ns=globals())  # from now on its filters are functions

NEIGHBORS = 64
MARGIN = 6  # small pixels mirrored at the border: a neighborhood's radius
WIDTHS = {"Multiquadric": [0.2, 0.5, 1, 2, 4], "Gaussian": [0.6, 0.7, 1, 2, 2.5, 3]}  # in small pixels
BRIGHTEST = 255


def read(path):
    """The image without the last rows and columns over a multiple of 16, as it is reduced by 4 twice."""
    reader = vtk.vtkImageReader2Factory.CreateImageReader2(path)
    if not reader:
        sys.exit(f"{path} is no image that VTK reads")
    reader.SetFileName(path)
    reader.Update()
    columns, rows = reader.GetOutput().GetDimensions()[:2]
    smallest = 16 * (MARGIN + 1)
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    if values.ndim > 1 or min(rows, columns) < smallest:
        sys.exit(f"{path}: expected a grayscale image of at least {smallest} x {smallest} pixels, found "
                 f"{columns} x {rows} with {values.shape[1] if values.ndim > 1 else 1} number(s) a pixel")
    image = values.reshape(rows, columns)[::-1].astype(float)  # VTK begins at the bottom
    return image[:rows // 16 * 16, :columns // 16 * 16]


def reduced(image, factor, averages):
    rows, columns = image.shape
    if not averages:
        return image[::factor, ::factor]
    return image.reshape(rows // factor, factor, columns // factor, factor).mean(axis=(1, 3))


def first(factor, averages):
    """The position of the first small pixel, in pixels of the large image."""
    return (factor - 1) / 2 if averages else 0


def spline(small, factor, averages, degree, shift=0):
    """The small image enlarged by a spline; a shift in small pixels puts it where it does not belong."""
    rows, columns = [(numpy.arange(n * factor) - first(factor, averages)) / factor + shift for n in small.shape]
    border = "mirror" if degree > 1 else "nearest"
    return ndimage.map_coordinates(small, numpy.meshgrid(rows, columns, indexing="ij"), order=degree, mode=border)


def grid(shape, origin, step, values=None):
    """A source of an image in the plane, in pixels of the large image."""
    dataset = vtk.vtkImageData()
    dataset.SetDimensions(shape[1], shape[0], 1)
    dataset.SetOrigin(origin, origin, 0)
    dataset.SetSpacing(step, step, 1)
    if values is not None:
        array = numpy_to_vtk(values.ravel(), deep=True)
        array.SetName("Brightness")
        dataset.GetPointData().SetScalars(array)
    producer = TrivialProducer()
    producer.GetClientSideObject().SetOutput(dataset)
    return producer


def radial(small, factor, averages, kernel, width):
    """The small image enlarged by LocalRBF, with the kernel's width in small pixels."""
    mirrored = numpy.pad(small, MARGIN, mode="reflect")
    samples = grid(mirrored.shape, first(factor, averages) - MARGIN * factor, factor, mirrored)
    large = numpy.multiply(small.shape, factor)
    enlarged = RBFExtend(Input=samples, ScalarArray=["POINTS", "Brightness"], Target=grid(large, 0, 1), Scheme="LocalRBF",
                         Kernel=kernel, KernelWidth=width * factor, NeighborCount=NEIGHBORS)
    return vtk_to_numpy(servermanager.Fetch(enlarged).GetPointData().GetArray("Brightness")).reshape(large)


def mean_square(image, other):
    return numpy.mean((image - numpy.clip(other, 0, BRIGHTEST)) ** 2)


def similarity(image, other):
    """The structural similarity index with uniform windows of 7 x 7 pixels and sample covariances, as in scikit-image."""
    size = 7
    mean = lambda values: ndimage.uniform_filter(values, size)
    covariance = lambda a, b: (mean(a * b) - mean(a) * mean(b)) * size ** 2 / (size ** 2 - 1)
    other = numpy.clip(other, 0, BRIGHTEST)
    c1, c2 = (0.01 * BRIGHTEST) ** 2, (0.03 * BRIGHTEST) ** 2
    index = ((2 * mean(image) * mean(other) + c1) * (2 * covariance(image, other) + c2)
             / ((mean(image) ** 2 + mean(other) ** 2 + c1) * (covariance(image, image) + covariance(other, other) + c2)))
    return index[size // 2:-(size // 2), size // 2:-(size // 2)].mean()


def chosen_width(small, factor, averages, kernel):
    """The width that restores the small image best from a smaller one, and its mean square error."""
    smaller = reduced(small, factor, averages)
    errors = {width: mean_square(small, radial(smaller, factor, averages, kernel, width)) for width in WIDTHS[kernel]}
    width = min(errors, key=errors.get)
    return width, errors[width]


def compare(name, image, factor, averages):
    """Prints a table of errors and returns the small image and two enlarged ones: cubic spline, chosen radial functions."""
    small = reduced(image, factor, averages)
    rows = [("linear", spline(small, factor, averages, 1))]
    rows += [(f"spline of degree {degree}", spline(small, factor, averages, degree)) for degree in (3, 4, 5)]
    choices = {kernel: chosen_width(small, factor, averages, kernel) for kernel in WIDTHS}
    best = min(choices, key=lambda kernel: choices[kernel][1])
    for kernel, (width, _) in choices.items():
        mark = ", chosen" if kernel == best else ""
        rows.append((f"{kernel}, width {width}{mark}", radial(small, factor, averages, kernel, width)))
        if kernel == best:
            radial_functions = rows[-1][1]
    misplaced = spline(small, factor, averages, 3, shift=0.5)
    rows.append(("degree 3, half a small pixel off", misplaced))
    way = "averages" if averages else "every 2nd pixel" if factor == 2 else "every 4th pixel"
    print(f"\n{name}, {factor} x, from {way}")
    print("                                         MRE   PSNR   SSIM")
    for label, enlarged in rows:
        error = mean_square(image, enlarged)
        print(f"{label:36} {error:7.2f} {10 * numpy.log10(BRIGHTEST ** 2 / error):6.2f} {similarity(image, enlarged):6.4f}",
              flush=True)
    return small, rows[1][1], radial_functions


def save(path, parts, factor):
    """Writes a square of each image, side by side, each pixel drawn as factor x factor ones."""
    values = numpy.hstack([numpy.kron(part, numpy.ones((factor, factor))) for part in parts])
    canvas = vtk.vtkImageData()
    canvas.SetDimensions(values.shape[1], values.shape[0], 1)
    pixels = numpy.clip(numpy.round(values), 0, BRIGHTEST).astype(numpy.uint8)[::-1].ravel()
    canvas.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(canvas)
    writer.Write()


shown = None
for path in sys.argv[4:] or [os.path.join(data, name) for name in ("camera.png", "ascent.pgm")]:
    image = read(path)
    for averages in (False, True):
        for factor in (2, 4):
            small, cubic, radial_functions = compare(os.path.basename(path), image, factor, averages)
            if shown is None and averages and factor == 4:
                shown = [numpy.kron(small, numpy.ones((4, 4))), cubic, radial_functions, image]
row, column = [int(0.15 * n) for n in shown[0].shape]  # the head of the man with the camera
save(picture, [part[row:row + 144, column + 60:column + 204] for part in shown], 3)

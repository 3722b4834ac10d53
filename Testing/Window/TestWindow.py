"""Starts the real ParaView window, lets it run a script with our filters, and compares a screenshot with the baseline.

The comparison is a loose one, for fonts, themes and drivers differ: both pictures are made small, then the mean difference
of their pixels must be small. It would not miss the thin curves, so these are looked for by their color. To renew the baseline after a wanted change, copy the reduced screenshot that the test writes
(it says where) to Baseline/.

Usage: pvpython TestWindow.py PARAVIEW IMPORT, the programs that show the window and take the picture.
"""

import os
import signal
import subprocess
import sys
import tempfile
import time

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

HERE = os.path.dirname(os.path.abspath(__file__))
WINDOW = "1400x900+0+0"
SIZE = (350, 225)
LARGEST_DIFFERENCE = 0.06  # mean over all pixels and colors, of 1
FEWEST_RED_PIXELS = 2000  # there are some 8000 of the upper curves, and some 250 without curves
PATIENCE = 200  # seconds


def read(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def pixels(image):
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[:, :, :3].astype(float) / 255


def reduced(image):
    """The picture at the baseline's size, smoothed first so that thin lines count."""
    smooth = vtk.vtkImageGaussianSmooth()
    smooth.SetInputData(image)
    smooth.SetDimensionality(2)
    smooth.SetStandardDeviations(1.5, 1.5)
    resize = vtk.vtkImageResize()
    resize.SetInputConnection(smooth.GetOutputPort())
    resize.SetOutputDimensions(SIZE[0], SIZE[1], 1)
    resize.Update()
    return resize.GetOutput()


def write(image, path):
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()


def wait_for(condition, process, what):
    """Polls until the condition holds; the window's end or the end of patience fail the test."""
    end = time.monotonic() + PATIENCE
    while not condition():
        if process.poll() is not None:
            sys.exit(f"{what}: the window ended with exit code {process.returncode}")
        if time.monotonic() > end:
            sys.exit(f"{what}: nothing within {PATIENCE} seconds")
        time.sleep(0.5)


def take_screenshot(import_program, path, process):
    """A screenshot of the whole screen, taken again until nothing moves any more."""
    last = []

    def is_still():
        subprocess.run([import_program, "-window", "root", path], check=True)
        now = pixels(read(path))
        still = bool(last) and now.shape == last[-1].shape and numpy.abs(now - last[-1]).mean() < 1e-4
        last.append(now)
        return still and len(last) > 4

    wait_for(is_still, process, "waiting for a picture at rest")


def show_and_shoot(paraview, import_program, home, screenshot):
    marker = os.path.join(home, "shown")
    environment = dict(os.environ, HOME=home, SURFACE_SCALARS_SHOWN=marker)
    environment.pop("XDG_CONFIG_HOME", None)
    # --dr: the settings of a first start, and no welcome dialog in front of the window.
    options = ["-qwindowgeometry", WINDOW, "--dr", "--script=" + os.path.join(HERE, "ShowContours.py")]
    process = subprocess.Popen([paraview, *options], env=environment, start_new_session=True)
    try:
        wait_for(lambda: os.path.exists(marker), process, "waiting for the script")
        take_screenshot(import_program, screenshot, process)
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)  # its own session: nobody else's process
        process.wait()


def check(screenshot, small, baseline):
    """What is wrong with the picture, or nothing."""
    values = pixels(read(screenshot))
    if values.std() < 0.02:
        return "the screenshot is empty"
    view = values[:, values.shape[1] // 4 :]
    red = numpy.count_nonzero(view[:, :, 0] - view[:, :, 2] > 0.25)
    print(f"red pixels in the view: {red}, wanted {FEWEST_RED_PIXELS}")
    if red < FEWEST_RED_PIXELS:
        return f"the curves are not to be seen: look at {screenshot}"
    ours = reduced(read(screenshot))
    write(ours, small)
    difference = numpy.abs(pixels(ours) - pixels(read(baseline))).mean()
    print(f"mean difference from the baseline: {difference:.4f}, allowed {LARGEST_DIFFERENCE}")
    if difference > LARGEST_DIFFERENCE:
        return f"the screenshot differs from the baseline by {difference:.3f}: compare {small} with {baseline}"
    return None


def main():
    paraview, import_program = sys.argv[1:3]
    output = os.environ["SURFACE_SCALARS_OUTPUT"]
    screenshot = os.path.join(output, "window.png")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as home:
        show_and_shoot(paraview, import_program, home, screenshot)
    sys.exit(check(screenshot, os.path.join(output, "window-small.png"), os.path.join(HERE, "Baseline", "Window.png")))


main()

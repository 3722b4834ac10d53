"""The demonstration that Utilities/demo.sh runs: contours of a distance on the points of Data/kitten.xyz.

In pvpython it writes contours.vtp and contours.png; in ParaView's window (paraview --script) it sets the pipeline up and
shows it. The environment says what to use: SURFACE_SCALARS_PLUGIN is the plugin's file, SURFACE_SCALARS_DATA the folder
Data, SURFACE_SCALARS_OUTPUT the folder to write to; without the last nothing is written.
"""

import math
import os

from paraview import simple

CENTER = [-0.05, 0.62, 0.12]  # a little above the head
CURVES = 24
PLASMA = "Plasma (matplotlib)"
SIZE = [1600, 2000]
PAPER = [0.985, 0.985, 0.99]
INK = [0.25, 0.25, 0.3]
POINT_COLOR = [0.66, 0.70, 0.74]


def contour_pipeline():
    """The points with a function, and its contours: what one would click together in the window."""
    scan = os.path.join(os.environ["SURFACE_SCALARS_DATA"], "kitten.xyz")
    table = simple.CSVReader(
        registrationName="kitten.xyz", FileName=[scan], HaveHeaders=0, FieldDelimiterCharacters=" "
    )
    points = simple.TableToPoints(
        registrationName="Points", Input=table, XColumn="Field 0", YColumn="Field 1", ZColumn="Field 2"
    )
    distance = simple.PointSetScalarFunction(
        registrationName="Distance", Input=points, Function="DistanceToPoint", Center=CENTER
    )
    distance.UpdatePipeline()
    low, high = distance.PointData["DistanceToPoint"].GetRange()
    step = (high - low) / CURVES
    contours = simple.PointSetContour(
        registrationName="Contours",
        Input=distance,
        ScalarArray=["POINTS", "DistanceToPoint"],
        ContourValues=[low + (i + 0.5) * step for i in range(CURVES)],
    )
    contours.UpdatePipeline()
    return distance, contours


def prepare_view(view):
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = PAPER
    azimuth = math.radians(-20)
    view.CameraPosition = [3 * math.sin(azimuth), 0.75, 3 * math.cos(azimuth)]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 1, 0]


def color_by_distance(display, view):
    simple.ColorBy(display, ("POINTS", "DistanceToPoint"))
    colors = simple.GetColorTransferFunction("DistanceToPoint")
    colors.ApplyPreset(PLASMA, True)
    display.SetScalarBarVisibility(view, True)
    legend = simple.GetScalarBar(colors, view)
    legend.Title = "distance"
    legend.ComponentTitle = ""
    legend.HorizontalTitle = 1
    legend.WindowLocation = "Any Location"
    legend.Position = [0.85, 0.08]
    legend.ScalarBarLength = 0.28
    legend.ScalarBarThickness = 12
    legend.TitleFontSize = legend.LabelFontSize = 18
    legend.TitleColor = legend.LabelColor = INK
    legend.UseCustomLabels = 1
    legend.CustomLabels = [0.2, 0.4, 0.6, 0.8, 1.0]
    legend.DrawTickMarks = 0
    legend.AddRangeLabels = 0
    legend.AutomaticLabelFormat = 0
    legend.LabelFormat = "%.1f"


def show_balls(points, radius, color, view):
    balls = simple.Glyph(
        Input=points,
        GlyphType="Sphere",
        GlyphMode="All Points",
        ScaleFactor=2 * radius,
        ScaleArray=["POINTS", "No scale array"],
        OrientationArray=["POINTS", "No orientation array"],
    )
    balls.GlyphType.ThetaResolution = balls.GlyphType.PhiResolution = 14
    display = simple.Show(balls, view)
    simple.ColorBy(display, None)
    display.AmbientColor = display.DiffuseColor = color
    display.Specular = 0.15
    display.SpecularPower = 20


def paint(points, contours, path):
    view = simple.CreateRenderView()
    view.ViewSize = SIZE
    prepare_view(view)
    view.UseAmbientOcclusion = 1
    view.UseSSAODefaultPresets = 0
    view.Radius, view.Bias, view.KernelSize, view.Blur = 0.09, 0.006, 128, 1
    view.KeyLightIntensity, view.KeyLightWarmth = 0.92, 0.55
    view.KeyLightAzimuth, view.KeyLightElevation = 25, 45
    view.UseFXAA = 1

    show_balls(points, 0.0045, POINT_COLOR, view)
    # What hides the far side: pale balls just below the points, along the normals that the file brings.
    inward = simple.Calculator(
        Input=points, Function='-("Field 3"*iHat+"Field 4"*jHat+"Field 5"*kHat)', ResultArrayName="Inward"
    )
    below = simple.WarpByVector(Input=inward, Vectors=["POINTS", "Inward"], ScaleFactor=0.023)
    show_balls(below, 0.02, [0.97, 0.965, 0.95], view)

    tubes = simple.Show(simple.Tube(Input=contours, Radius=0.0055, NumberofSides=24), view)
    color_by_distance(tubes, view)
    tubes.Specular = 0.4
    tubes.SpecularPower = 30

    simple.ResetCamera(view)
    view.GetActiveCamera().Dolly(1.5)
    simple.Render(view)
    simple.SaveScreenshot(path, view, ImageResolution=SIZE)


def show_in_window(points, contours):
    view = simple.GetActiveViewOrCreate("RenderView")
    prepare_view(view)
    cloud = simple.Show(points, view)
    cloud.SetRepresentationType("Point Gaussian")
    cloud.GaussianRadius = 0.004
    simple.ColorBy(cloud, None)
    cloud.AmbientColor = cloud.DiffuseColor = POINT_COLOR
    curves = simple.Show(contours, view)
    curves.LineWidth = 4
    curves.RenderLinesAsTubes = 1
    color_by_distance(curves, view)
    simple.SetActiveSource(contours)
    simple.ResetCamera(view)
    simple.Render(view)


def main():
    simple.LoadPlugin(os.environ["SURFACE_SCALARS_PLUGIN"], remote=False, ns=vars(simple))
    points, contours = contour_pipeline()
    folder = os.environ.get("SURFACE_SCALARS_OUTPUT")
    if not folder:
        show_in_window(points, contours)
        return
    simple.SaveData(os.path.join(folder, "contours.vtp"), contours, DataMode="Binary")
    information = contours.GetDataInformation()
    print(f"{information.GetNumberOfCells()} curves of {CURVES} values on {points.GetDataInformation().GetNumberOfPoints():,} points")
    paint(points, contours, os.path.join(folder, "contours.png"))


main()

"""Represents the heights of a terrain, and a function in a volume, by few centers, and draws what is gained and lost.

usage: pvpython approximate_function.py PLUGIN jacksboro.vtk TERRAIN.png VOLUME.png

PLUGIN is SurfaceScalars.so; jacksboro.vtk lies in Data. Both pictures show the function, its approximation, the error
and the centers (terrain), or the critical points that were kept (volume).
"""

import sys

from paraview.simple import *

if len(sys.argv) != 5:
    sys.exit(__doc__)
plugin, terrain_file, terrain_picture, volume_picture = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())  # from now on its filters are functions


def report(title, approximation):
    data = servermanager.Fetch(approximation, idx=0).GetFieldData()
    figure = {data.GetArrayName(i): data.GetArray(i).GetTuple1(0) for i in range(data.GetNumberOfArrays())}
    print(f"{title}: {figure['CentreCount']:.0f} centers, {figure['StarCount']:.0f} in stars; largest error "
          f"{figure['LInfinityError']:.3g}, mean {figure['MeanError']:.3g}; {figure['ModelBytes']:.0f} of "
          f"{figure['ScalarBytes']:.0f} bytes, {100 * figure['SpaceSaving']:.1f}% saved; {figure['Missing']:.0f} critical "
          "points missing")


def balls(source, radius):
    glyphs = Glyph(Input=source, GlyphType="Sphere", GlyphMode="All Points", ScaleArray=["POINTS", "No scale array"],
                   OrientationArray=["POINTS", "No orientation array"], ScaleFactor=2 * radius)
    glyphs.GlyphType.ThetaResolution = glyphs.GlyphType.PhiResolution = 8
    return glyphs


LOOKS = {"CriticalType": (0, 3, "Cool to Warm (Extended)")}  # the range of an array's colors, and their name


def paint(drawn, array, view):
    """Colors something by an array, and explains the colors in the upper right corner."""
    ColorBy(drawn, ("POINTS", array))
    low, high, preset = LOOKS[array]
    table = GetColorTransferFunction(array)
    table.ApplyPreset(preset, True)
    table.AutomaticRescaleRangeMode = "Never"
    table.RescaleTransferFunction(low, high)
    if array == "CriticalType":
        return
    bar = GetScalarBar(table, view)
    bar.Title = bar.ComponentTitle = ""
    bar.Orientation, bar.WindowLocation, bar.Position = "Vertical", "Any Location", [0.88, 0.62]
    bar.ScalarBarLength, bar.ScalarBarThickness, bar.LabelFontSize = 0.28, 12, 14
    bar.LabelColor = [0, 0, 0]
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = bar.RangeLabelFormat = "%.0f" if high > 100 else "%.2f"
    drawn.SetScalarBarVisibility(view, True)


def view_of(shown, title, elevation=0, azimuth=0, zoom=1.0):
    """shown: pairs of a source and an array or a color; angles in degrees."""
    view = CreateView("RenderView")
    view.ViewSize = [700, 600]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    for source, look in shown:
        drawn = Show(source, view)
        if isinstance(look, str):
            paint(drawn, look, view)
        else:
            drawn.ColorArrayName = ["POINTS", ""]
            drawn.AmbientColor = drawn.DiffuseColor = look
    text = Show(Text(Text=title), view)
    text.Color = [0, 0, 0]
    text.FontSize = 22
    text.WindowLocation = "Upper Center"
    ResetCamera(view)
    camera = view.GetActiveCamera()
    camera.Azimuth(azimuth)
    camera.Elevation(elevation)
    camera.Zoom(zoom)
    return view


def save(views, picture):
    layout = CreateLayout()
    top = layout.SplitVertical(0, 0.5)
    first, third = layout.SplitHorizontal(top, 0.5), layout.SplitHorizontal(top + 1, 0.5)
    for view, cell in zip(views, (first, first + 1, third, third + 1)):
        layout.AssignView(cell, view)
    layout.SetSize(1400, 1200)
    SaveScreenshot(picture, layout, ImageResolution=[1120, 960])


# The terrain: of its peaks and pits those that matter, and a center for every fiftieth point.
terrain = LegacyVTKReader(FileNames=[terrain_file])
heights = MeshlessApproximation(
    Input=terrain, ScalarArray=["POINTS", "Elevation"], SampleFraction=0.02, PersistenceThreshold=0.1)
report("terrain", heights)
count = terrain.GetDataInformation().GetNumberOfPoints()
low, high = terrain.PointData["Elevation"].GetRange()
worst = max(abs(bound) for bound in heights.PointData["ApproximationError"].GetRange())
LOOKS["Elevation"] = low, high, "Viridis (matplotlib)"
LOOKS["ElevationApproximation"] = low, high, "Viridis (matplotlib)"
LOOKS["ApproximationError"] = -worst, worst, "Cool to Warm (Extended)"


def relief(source, name):
    return WarpByScalar(Input=source, Scalars=["POINTS", name], ScaleFactor=8)


approximated = relief(heights, "ElevationApproximation")
centers = RBFEvaluate(Input=OutputPort(heights, 1), Target=OutputPort(heights, 1), ResultArrayName="Height")


south = {"elevation": -40, "zoom": 1.35}
save([
    view_of([(relief(heights, "Elevation"), "Elevation")], f"elevation in m, {count:,} points", **south),
    view_of([(approximated, "ElevationApproximation")], "approximation", **south),
    view_of([(approximated, "ApproximationError")], "error in m", **south),
    view_of([(approximated, [0.85, 0.85, 0.82]), (balls(relief(centers, "Height"), 120), [0.8, 0.1, 0.1])], "centers",
            **south),
], terrain_picture)

# The volume: ParaView's Wavelet, an image of 41^3 points.
wavelet = Wavelet(WholeExtent=[-20, 20, -20, 20, -20, 20], XFreq=20, YFreq=15, ZFreq=15)
volume = MeshlessApproximation(
    Input=wavelet, ScalarArray=["POINTS", "RTData"], SampleFraction=0.02, PersistenceThreshold=0.1)
report("volume", volume)
low, high = volume.PointData["RTData"].GetRange()
worst = max(abs(bound) for bound in volume.PointData["ApproximationError"].GetRange())
LOOKS["RTData"] = low, high, "Viridis (matplotlib)"
LOOKS["RTDataApproximation"] = low, high, "Viridis (matplotlib)"
LOOKS["ApproximationError"] = -worst, worst, "Cool to Warm (Extended)"
cut = Slice(Input=volume, SliceType="Plane")
cut.SliceType.Origin = [0, 0, 4.5]
cut.SliceType.Normal = [0, 0, 1]
surfaces = Contour(Input=volume, ContourBy=["POINTS", "RTDataApproximation"], Isosurfaces=[0.55 * low + 0.45 * high])
box = Outline(Input=wavelet)
kept = Threshold(Input=OutputPort(volume, 2), Scalars=["POINTS", "Prescribed"], LowerThreshold=1, UpperThreshold=1)

save([
    view_of([(cut, "RTData")], "f at z = 4.5", zoom=1.25),
    view_of([(cut, "RTDataApproximation")], "approximation", zoom=1.25),
    view_of([(cut, "ApproximationError")], "error", zoom=1.25),
    view_of([(surfaces, [0.85, 0.85, 0.82]), (box, [0.4, 0.4, 0.4]), (balls(kept, 0.7), "CriticalType")],
            "a level set, critical points", elevation=-20, azimuth=30),
], volume_picture)

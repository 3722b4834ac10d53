"""Contours the height of a scan: points without a mesh come in as text, curves go out as a .vtp file.

usage: pvpython contour_scan.py PLUGIN SCAN.xyz CONTOURS.vtp [COUNT]

PLUGIN is SurfaceScalars.so. Each line of SCAN.xyz begins with x y z, separated by blanks. COUNT heights (20) are spread
evenly between the lowest and the highest y.
"""

import sys

from paraview.simple import *

if len(sys.argv) < 4:
    sys.exit(__doc__)
plugin, scan, result = sys.argv[1:4]
count = int(sys.argv[4]) if len(sys.argv) > 4 else 20

LoadPlugin(plugin, remote=False, ns=globals())  # from now on its filters are functions

table = CSVReader(FileName=[scan], HaveHeaders=0, FieldDelimiterCharacters=" ")
points = TableToPoints(Input=table, XColumn="Field 0", YColumn="Field 1", ZColumn="Field 2")

height = PointSetScalarFunction(Input=points, Function="Height", Direction=[0, 1, 0])
height.UpdatePipeline()
low, high = height.PointData["Height"].GetRange()

contours = PointSetContour(Input=height, ScalarArray=["POINTS", "Height"])
contours.ContourValues = [low + (i + 0.5) / count * (high - low) for i in range(count)]
contours.UpdatePipeline()

SaveData(result, contours, DataMode="Binary")  # every ParaView reads it: Documentation/troubleshooting.md

curves = servermanager.Fetch(contours)
closed = sum(curves.GetCellData().GetArray("Closed").GetValue(i) for i in range(curves.GetNumberOfCells()))
print(f"{points.GetDataInformation().GetNumberOfPoints()} points, {count} heights, "
      f"{curves.GetNumberOfCells()} curves, {closed} of them closed")

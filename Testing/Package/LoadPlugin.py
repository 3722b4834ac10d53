"""Loads the plugin file given as the argument and runs a filter of it."""

import sys

from paraview.simple import LoadPlugin, Sphere

LoadPlugin(sys.argv[1], remote=False, ns=globals())

heights = PointSetScalarFunction(Input=Sphere(), Function="Height")  # noqa: F821: comes with the plugin
heights.UpdatePipeline()
if "Height" not in heights.PointData.keys():
    sys.exit(f"expected a point array Height, found {heights.PointData.keys()}")

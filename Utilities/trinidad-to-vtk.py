#!/usr/bin/env python3
"""Turns the heights around Trinidad, Colorado, of the Debian package libncarg-data into an image that ParaView opens.

usage: trinidad-to-vtk.py trinidad.nc OUTPUT.vtk

The image lies in the plane z = 0 around the origin, in m along the parallel and the meridian through its middle, and has
the point array Elevation in m (the file has feet). Needs python3-scipy.
"""

import sys

import numpy
from scipy.io import netcdf_file

DEGREE = 111195.0  # m, on a sphere of radius 6371 km
FOOT = 0.3048


def main(source, target):
    with netcdf_file(source, mmap=False) as file:
        latitude, longitude = (file.variables[name][:].astype(float) for name in ("lat", "lon"))
        elevation = FOOT * file.variables["data"][:].astype(float)
    x, y = longitude - longitude.mean(), latitude - latitude.mean()
    x, y = DEGREE * numpy.cos(numpy.radians(latitude.mean())) * x, DEGREE * y
    with open(target, "wb") as file:
        file.write(b"# vtk DataFile Version 3.0\nElevation around Trinidad, Colorado\nBINARY\nDATASET STRUCTURED_POINTS\n")
        file.write(f"DIMENSIONS {len(x)} {len(y)} 1\nORIGIN {x[0]:.10g} {y[0]:.10g} 0\n".encode())
        file.write(f"SPACING {x[1] - x[0]:.10g} {y[1] - y[0]:.10g} 1\nPOINT_DATA {elevation.size}\n".encode())
        file.write(b"SCALARS Elevation float 1\nLOOKUP_TABLE default\n")
        file.write(elevation.astype(">f4").tobytes())


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])

#!/usr/bin/env python3
"""Turns a relief of the earth on a grid of longitude and latitude into a point set that ParaView opens.

usage: etopo-to-vtk.py etopo20.cdf OUTPUT.vtk

The file is netCDF with the variable ROSE over latitude and longitude, as in the Debian package ferret-datasets. The
points lie on a sphere of radius 6371 km around the origin, with the point array Relief in m. Towards the poles a row
keeps fewer and fewer of its values, so that the points are about equally dense everywhere. Needs python3-scipy.
"""

import sys

import numpy
from scipy.io import netcdf_file

EARTH_RADIUS = 6371.0  # km


def read(path):
    """Longitudes and latitudes in radians, and the relief with one row per latitude."""
    with netcdf_file(path, mmap=False) as file:
        relief = file.variables["ROSE"]
        latitude, longitude = (numpy.radians(file.variables[name][:].astype(float)) for name in relief.dimensions)
        values = relief[:].astype(float)
    once = longitude - longitude[0] < 2 * numpy.pi - 1e-9  # without the column that comes round again
    return longitude[once], latitude, values[:, once]


def spread(longitude, latitude, values):
    """Points on the sphere and their relief, as dense at the poles as at the equator."""
    points, relief = [], []
    for phi, row in zip(latitude, values):
        kept = max(1, round(len(row) * numpy.cos(phi)))
        columns = (numpy.arange(kept) * len(row)) // kept
        angles = longitude[columns]
        points.append(EARTH_RADIUS * numpy.column_stack(
            (numpy.cos(phi) * numpy.cos(angles), numpy.cos(phi) * numpy.sin(angles), numpy.full(kept, numpy.sin(phi)))))
        relief.append(row[columns])
    return numpy.concatenate(points), numpy.concatenate(relief)


def write(path, points, relief):
    count = len(relief)
    vertices = numpy.column_stack((numpy.ones(count), numpy.arange(count)))
    with open(path, "wb") as file:
        file.write(b"# vtk DataFile Version 3.0\nRelief of the earth\nBINARY\nDATASET POLYDATA\n")
        file.write(f"POINTS {count} double\n".encode() + points.astype(">f8").tobytes())
        file.write(f"\nVERTICES {count} {2 * count}\n".encode() + vertices.astype(">i4").tobytes())
        file.write(f"\nPOINT_DATA {count}\nSCALARS Relief double 1\nLOOKUP_TABLE default\n".encode())
        file.write(relief.astype(">f8").tobytes())


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    write(sys.argv[2], *spread(*read(sys.argv[1])))

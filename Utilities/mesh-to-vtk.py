#!/usr/bin/env python3
"""Turns a mesh or a terrain into a file that ParaView opens.

usage: mesh-to-vtk.py INPUT OUTPUT.vtk

INPUT is one of

  MESH.off                  triangles
  ctcbay.nc                 the bottom of Chesapeake Bay, of the Debian package libncarg-data: triangles in a plane, km
                            east and north of the middle, with the point array Depth in m
  jacksboro_fault_dem.npz   heights on a grid, of the Debian package python-matplotlib-data: an image, m east and
                            north of a corner, with the point array Elevation in m

The last two need python3-numpy, ctcbay.nc python3-scipy, too.
"""

import sys

import numpy

METERS_PER_DEGREE = 111194.9  # of latitude, on a sphere of radius 6371 km


def header(title, kind):
    return f"# vtk DataFile Version 3.0\n{title}\nBINARY\nDATASET {kind}\n".encode()


def scalars(name, values, kind, vtk_kind):
    lead = f"\nPOINT_DATA {values.size}\nSCALARS {name} {vtk_kind} 1\nLOOKUP_TABLE default\n"
    return lead.encode() + values.astype(kind).tobytes()


def surface(title, points, triangles):
    corners = numpy.column_stack((numpy.full(len(triangles), 3), triangles))
    return (header(title, "POLYDATA")
            + f"POINTS {len(points)} float\n".encode() + points.astype(">f4").tobytes()
            + f"\nPOLYGONS {len(triangles)} {4 * len(triangles)}\n".encode() + corners.astype(">i4").tobytes())


def read_off(path):
    with open(path) as file:
        numbers = file.read().split()
    if numbers[0] != "OFF":
        sys.exit(f"{path} is not in OFF format")
    point_count, face_count = int(numbers[1]), int(numbers[2])
    end = 4 + 3 * point_count
    points = numpy.array(numbers[4:end], float).reshape(-1, 3)
    faces = numpy.array(numbers[end:end + 4 * face_count], int).reshape(-1, 4)
    if not (faces[:, 0] == 3).all():
        sys.exit(f"{path} has faces that are not triangles")
    return surface(f"{point_count} points", points, faces[:, 1:])


def read_bay(path):
    from scipy.io import netcdf_file
    with netcdf_file(path, mmap=False) as file:
        longitude, latitude, depth, elements = (file.variables[name][:].copy() for name in ("lon", "lat", "depth", "ele"))
    east = (longitude - longitude.mean()) * numpy.cos(numpy.radians(latitude.mean()))
    north = latitude - latitude.mean()
    points = numpy.column_stack((east, north, numpy.zeros(len(depth)))) * METERS_PER_DEGREE / 1000
    return surface("Chesapeake Bay", points, elements - 1) + scalars("Depth", depth, ">f4", "float")


def read_grid(path):
    terrain = numpy.load(path)
    elevation = terrain["elevation"][::-1]  # rows come from north to south
    rows, columns = elevation.shape
    north = float(terrain["dy"]) * METERS_PER_DEGREE
    east = float(terrain["dx"]) * METERS_PER_DEGREE * numpy.cos(numpy.radians(float(terrain["ymin"] + terrain["ymax"]) / 2))
    return (header("Jacksboro fault", "STRUCTURED_POINTS")
            + f"DIMENSIONS {columns} {rows} 1\nORIGIN 0 0 0\nSPACING {east:.4f} {north:.4f} 1".encode()
            + scalars("Elevation", elevation, ">i2", "short"))


READERS = {"off": read_off, "nc": read_bay, "npz": read_grid}

if __name__ == "__main__":
    suffix = sys.argv[1].rsplit(".", 1)[-1] if len(sys.argv) == 3 else ""
    if suffix not in READERS:
        sys.exit(__doc__)
    content = READERS[suffix](sys.argv[1])
    with open(sys.argv[2], "wb") as output:
        output.write(content)

#!/usr/bin/env python3
"""Turns the rainfall data SIC97 of the R package gstat into legacy VTK files that ParaView opens.

usage: sic97-to-vtk.py sic97.rda FOLDER

Writes sic97_observed.vtk (100 stations), sic97_held_out.vtk (the other 367), both with the point array Rainfall in
1/10 mm, and sic97_dem.vtk, an image with the array Elevation in m. Coordinates are in m, z = 0. Needs python3-rdata.
"""

import pathlib
import sys
import warnings

import numpy
import rdata


def stations(data):
    """Coordinates (n x 2), rainfall and numbers of the stations of an R SpatialPointsDataFrame."""
    return (numpy.asarray(data.coords.values, dtype=float),
            data.data["rainfall"].to_numpy(dtype=float),
            data.data["ID"].to_numpy())


def write_stations(path, coordinates, rainfall):
    with open(path, "w") as file:
        count = len(rainfall)
        file.write("# vtk DataFile Version 3.0\nSIC97 rainfall stations\nASCII\nDATASET POLYDATA\n")
        file.write(f"POINTS {count} double\n")
        file.writelines(f"{x:.10g} {y:.10g} 0\n" for x, y in coordinates)
        file.write(f"VERTICES {count} {2 * count}\n")
        file.writelines(f"1 {i}\n" for i in range(count))
        file.write(f"POINT_DATA {count}\nSCALARS Rainfall double 1\nLOOKUP_TABLE default\n")
        file.writelines(f"{value:.10g}\n" for value in rainfall)


def write_elevation(path, data):
    columns, rows = (int(n) for n in getattr(data.grid, "cells.dim"))
    x, y = getattr(data.grid, "cellcentre.offset")
    dx, dy = data.grid.cellsize
    # R's grids start at the top left, VTK's at the bottom left.
    elevation = data.data.iloc[:, 0].to_numpy(dtype=float).reshape(rows, columns)[::-1]
    with open(path, "w") as file:
        file.write("# vtk DataFile Version 3.0\nElevation of Switzerland\nASCII\nDATASET STRUCTURED_POINTS\n")
        file.write(f"DIMENSIONS {columns} {rows} 1\nORIGIN {x:.10g} {y:.10g} 0\nSPACING {dx:.10g} {dy:.10g} 1\n")
        file.write(f"POINT_DATA {columns * rows}\nSCALARS Elevation double 1\nLOOKUP_TABLE default\n")
        file.writelines(f"{value:.10g}\n" for value in elevation.ravel())


def main(source, folder):
    warnings.simplefilter("ignore")  # rdata says that it does not know R's spatial classes
    data = rdata.conversion.convert(rdata.parser.parse_file(source), default_encoding="utf-8")
    observed, observed_rain, observed_numbers = stations(data["sic_obs"])
    everywhere, rain, numbers = stations(data["sic_full"])
    held_out = ~numpy.isin(numbers, observed_numbers)
    folder = pathlib.Path(folder)
    write_stations(folder / "sic97_observed.vtk", observed, observed_rain)
    write_stations(folder / "sic97_held_out.vtk", everywhere[held_out], rain[held_out])
    write_elevation(folder / "sic97_dem.vtk", data["demstd"])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])

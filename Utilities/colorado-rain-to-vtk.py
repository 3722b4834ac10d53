#!/usr/bin/env python3
"""Turns the monthly rain of Colorado in the R package fields into legacy VTK files that ParaView opens.

usage: colorado-rain-to-vtk.py COmonthlyMet.rda FOLDER

Writes colorado_rain.vtk, the stations that have all twelve months of the year in which most stations do, with the point
arrays Rain01 to Rain12 in cm, Height in m and the field Year, and colorado_terrain.vtk, an image with the array Elevation
in m. Coordinates are in km, eastward and northward along the parallel and the meridian through the middle; z = 0. Needs
python3-rdata.
"""

import pathlib
import sys
import warnings

import numpy
import rdata

DEGREE = 111.195  # km, on a sphere of radius 6371 km


def write_stations(path, places, heights, rain, year):
    with open(path, "w") as file:
        count = len(places)
        file.write("# vtk DataFile Version 3.0\nMonthly rain in Colorado\nASCII\nDATASET POLYDATA\n")
        file.write(f"FIELD FieldData 1\nYear 1 1 int\n{year}\n")
        file.write(f"POINTS {count} double\n")
        file.writelines(f"{x:.8g} {y:.8g} 0\n" for x, y in places)
        file.write(f"VERTICES {count} {2 * count}\n")
        file.writelines(f"1 {i}\n" for i in range(count))
        file.write(f"POINT_DATA {count}\n")
        for name, values in [("Height", heights)] + [(f"Rain{month + 1:02}", rain[month]) for month in range(12)]:
            file.write(f"SCALARS {name} double 1\nLOOKUP_TABLE default\n")
            file.writelines(f"{value:.8g}\n" for value in values)


def write_terrain(path, x, y, elevation):
    with open(path, "w") as file:
        file.write("# vtk DataFile Version 3.0\nElevation of Colorado\nASCII\nDATASET STRUCTURED_POINTS\n")
        file.write(f"DIMENSIONS {len(x)} {len(y)} 1\nORIGIN {x[0]:.8g} {y[0]:.8g} 0\n")
        file.write(f"SPACING {x[1] - x[0]:.8g} {y[1] - y[0]:.8g} 1\n")
        file.write(f"POINT_DATA {elevation.size}\nSCALARS Elevation double 1\nLOOKUP_TABLE default\n")
        file.writelines(f"{value:.8g}\n" for value in elevation.T.ravel())


def main(source, folder):
    warnings.simplefilter("ignore")  # rdata says that it does not know all of R's classes
    data = rdata.conversion.convert(rdata.parser.parse_file(source), default_encoding="utf-8")
    rain = numpy.asarray(data["CO.ppt"])  # year, month, station
    complete = numpy.isfinite(rain).all(axis=1)
    year = complete.sum(axis=1).argmax()
    grid = data["CO.elevGrid"]
    west, east, south, north = grid["x"][0], grid["x"][-1], grid["y"][0], grid["y"][-1]
    middle = [(west + east) / 2, (south + north) / 2]
    scale = DEGREE * numpy.array([numpy.cos(numpy.radians(middle[1])), 1])
    places = (data["CO.loc"].to_numpy(dtype=float) - middle) * scale
    folder = pathlib.Path(folder)
    chosen = complete[year]
    write_stations(folder / "colorado_rain.vtk", places[chosen], numpy.asarray(data["CO.elev"])[chosen],
                   rain[year][:, chosen], int(data["CO.years"][year]))
    write_terrain(folder / "colorado_terrain.vtk", (numpy.asarray(grid["x"]) - middle[0]) * scale[0],
                  (numpy.asarray(grid["y"]) - middle[1]) * scale[1], numpy.asarray(grid["z"]))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])

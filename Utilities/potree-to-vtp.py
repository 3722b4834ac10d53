#!/usr/bin/env python3
"""Converts a point cloud in Potree's octree format (binary nodes, versions 1.4 to 1.7) to a .vtp file.

usage: potree-to-vtp.py FOLDER OUTPUT.vtp     FOLDER holds cloud.js

Coordinates are written in double precision with one vertex cell for all points; colors become the array RGB, normals the
array Normals. The data are inline and base64 (DataMode Binary), which every ParaView reads. Prints the number of points.
"""

import array
import base64
import json
import math
import pathlib
import struct
import sys

# Bytes of a point's attributes, in the order in which cloud.js lists them.
ATTRIBUTES = {"POSITION_CARTESIAN": "3I", "COLOR_PACKED": "4B", "NORMAL_SPHEREMAPPED": "2B"}


def node_origin(name, box):
    """Lower corner of an octree node. `name` is r and one digit per level: 4 = upper x, 2 = upper y, 1 = upper z."""
    corner = [box["lx"], box["ly"], box["lz"]]
    size = [box["ux"] - box["lx"], box["uy"] - box["ly"], box["uz"] - box["lz"]]
    for digit in name[1:]:
        for axis in range(3):
            size[axis] /= 2
            if int(digit) & (4 >> axis):
                corner[axis] += size[axis]
    return corner


def sphere_mapped(u, v):
    """Unit normal from two bytes: the inverse of the sphere map."""
    x, y = u / 255 * 2 - 1, v / 255 * 2 - 1
    z = 1 - x * x - y * y
    stretch = 2 * math.sqrt(max(z, 0))
    normal = (x * stretch, y * stretch, 2 * z - 1)
    length = math.sqrt(sum(c * c for c in normal))
    return tuple(c / length for c in normal)


def read_cloud(folder):
    cloud = json.loads((folder / "cloud.js").read_text())
    attributes = cloud["pointAttributes"]
    unknown = [a for a in attributes if a not in ATTRIBUTES]
    if unknown:
        sys.exit(f"{folder}: expected the attributes {', '.join(ATTRIBUTES)}, found {', '.join(unknown)}")
    record = struct.Struct("<" + "".join(ATTRIBUTES[a] for a in attributes))
    has_normals = "NORMAL_SPHEREMAPPED" in attributes
    scale = cloud["scale"]

    points, colors, normals = array.array("d"), array.array("B"), array.array("f")
    for file in sorted((folder / cloud["octreeDir"]).rglob("*.bin")):
        ox, oy, oz = node_origin(file.stem, cloud["boundingBox"])
        for x, y, z, red, green, blue, _, *mapped in record.iter_unpack(file.read_bytes()):
            points.extend((ox + x * scale, oy + y * scale, oz + z * scale))
            colors.extend((red, green, blue))
            if has_normals:
                normals.extend(sphere_mapped(*mapped))
    return points, colors, normals


def data_array(values, type_name, attributes):
    values = array.array(values.typecode, values)
    if sys.byteorder == "big":
        values.byteswap()
    data = values.tobytes()
    text = base64.b64encode(struct.pack("<Q", len(data)) + data).decode()
    return f'<DataArray type="{type_name}" {attributes} format="binary">{text}</DataArray>\n'


def write_vtp(path, points, colors, normals):
    count = len(points) // 3
    with open(path, "w", encoding="ascii") as out:
        out.write('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n')
        out.write(f'<PolyData>\n<Piece NumberOfPoints="{count}" NumberOfVerts="1">\n<PointData>\n')
        out.write(data_array(colors, "UInt8", 'Name="RGB" NumberOfComponents="3"'))
        if normals:
            out.write(data_array(normals, "Float32", 'Name="Normals" NumberOfComponents="3"'))
        out.write("</PointData>\n<Points>\n")
        out.write(data_array(points, "Float64", 'Name="Points" NumberOfComponents="3"'))
        out.write("</Points>\n<Verts>\n")
        out.write(data_array(array.array("q", range(count)), "Int64", 'Name="connectivity"'))
        out.write(data_array(array.array("q", [count]), "Int64", 'Name="offsets"'))
        out.write("</Verts>\n</Piece>\n</PolyData>\n</VTKFile>\n")
    return count


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    count = write_vtp(sys.argv[2], *read_cloud(pathlib.Path(sys.argv[1])))
    print(f"{sys.argv[2]}: {count:,} points")


if __name__ == "__main__":
    main()

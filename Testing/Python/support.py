"""What the pvpython tests share: the plugin, places to write to, samples of known surfaces."""

import math
import os
import random

import numpy
import vtk
from paraview import simple
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy


def load_plugin():
    """Loads the plugin under test; its filters then are functions of paraview.simple."""
    simple._DisableFirstRenderCameraReset()
    simple.LoadPlugin(os.environ["SURFACE_SCALARS_PLUGIN"], remote=False, ns=vars(simple))


def output_file(name):
    """A file to write to; an older one of the same name is removed."""
    path = os.path.join(os.environ["SURFACE_SCALARS_OUTPUT"], name)
    if os.path.exists(path):
        os.remove(path)
    return path


def kitten_points():
    """The scan that ships with the project: 3 columns; the file's further columns are normals."""
    path = os.path.join(os.environ["SURFACE_SCALARS_DATA"], "kitten.xyz")
    return numpy.loadtxt(path)[:, :3]


def torus_points(count=4000, seed=1):
    """Random samples by area of the torus with radii 1 and 0.4 around z."""
    generator = random.Random(seed)
    points = []
    while len(points) < count:
        u, v = generator.uniform(0, 2 * math.pi), generator.uniform(0, 2 * math.pi)
        axis_distance = 1 + 0.4 * math.cos(v)
        if 1.4 * generator.random() <= axis_distance:
            points.append((axis_distance * math.cos(u), axis_distance * math.sin(u), 0.4 * math.sin(v)))
    return numpy.array(points)


def polydata(points, **arrays):
    """Points without cells, with point arrays; the first of them is the active one."""
    result = vtk.vtkPolyData()
    result.SetPoints(vtk.vtkPoints())
    result.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=float), deep=True))
    for name, values in arrays.items():
        array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
        array.SetName(name)
        result.GetPointData().AddArray(array)
    if arrays:
        result.GetPointData().SetActiveScalars(next(iter(arrays)))
    return result


def torus_mesh(columns=48, rows=24):
    """The same torus closed, as points and triangles (three columns of ids)."""
    u, v = numpy.meshgrid(
        numpy.arange(columns) * 2 * math.pi / columns, numpy.arange(rows) * 2 * math.pi / rows
    )
    radius = 1 + 0.4 * numpy.cos(v)
    points = numpy.stack([radius * numpy.cos(u), radius * numpy.sin(u), 0.4 * numpy.sin(v)], axis=-1).reshape(-1, 3)
    corner = numpy.arange(columns * rows).reshape(rows, columns)
    right, up = numpy.roll(corner, -1, axis=1), numpy.roll(corner, -1, axis=0)
    across = numpy.roll(right, -1, axis=0)
    triangles = numpy.concatenate([
        numpy.stack([corner, right, across], axis=-1).reshape(-1, 3),
        numpy.stack([corner, across, up], axis=-1).reshape(-1, 3),
    ])
    return points, triangles


def mesh(points, triangles, **arrays):
    """Points and triangles, with point arrays; the first of them is the active one."""
    result = polydata(points, **arrays)
    corners = numpy.column_stack([numpy.full(len(triangles), 3), triangles]).ravel()
    cells = vtk.vtkCellArray()
    cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(corners, deep=True))
    result.SetPolys(cells)
    return result


def source(dataset):
    """A pipeline source that holds the dataset."""
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(dataset)
    return producer


THREE_STEPS = """
executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
information.Remove(executive.TIME_STEPS())
for step in (0.0, 1.0, 2.0):
    information.Append(executive.TIME_STEPS(), step)
information.Remove(executive.TIME_RANGE())
information.Append(executive.TIME_RANGE(), 0.0)
information.Append(executive.TIME_RANGE(), 2.0)
"""


def three_steps(script):
    """A programmable source of polydata that offers the time steps 0, 1 and 2."""
    return simple.ProgrammableSource(
        OutputDataSetType="vtkPolyData", Script=script, ScriptRequestInformation=THREE_STEPS
    )


def fetch(proxy, port=0):
    """The data of an output port, up to date."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def point_array(dataset, name):
    return vtk_to_numpy(dataset.GetPointData().GetArray(name))


def table_column(table, name):
    return vtk_to_numpy(table.GetColumnByName(name))


def cell_array(dataset, name):
    return vtk_to_numpy(dataset.GetCellData().GetArray(name))


def field_array(dataset, name):
    return vtk_to_numpy(dataset.GetFieldData().GetArray(name))


def positions(dataset):
    return vtk_to_numpy(dataset.GetPoints().GetData())


class Messages:
    """Within `with Messages() as messages`, what VTK says goes to messages.text instead of the console."""

    def __enter__(self):
        self._previous = vtk.vtkOutputWindow.GetInstance()
        self._window = vtk.vtkStringOutputWindow()
        vtk.vtkOutputWindow.SetInstance(self._window)
        return self

    def __exit__(self, *error):
        vtk.vtkOutputWindow.SetInstance(self._previous)

    @property
    def text(self):
        return self._window.GetOutput()

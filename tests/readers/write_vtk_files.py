#!/usr/bin/python3
"""Writes the files of tests/io/mesh/vtk_files by VTK itself (Debian's python3-vtk9): one surface in all of its formats.

Usage: tests/readers/write_vtk_files.py tests/io/mesh/vtk_files
"""
import pathlib
import sys

import vtk

POINTS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0.5, 0.25))


def cells(*lists):
    array = vtk.vtkCellArray()
    for ids in lists:
        array.InsertNextCell(len(ids), ids)
    return array


def numbers(kind, name, components, values):
    array = kind()
    array.SetName(name)
    array.SetNumberOfComponents(components)
    for value in values:
        array.InsertNextValue(value)
    return array


def surface():
    """A vertex, a quadrangle, a strip of one triangle; data of points and cells."""
    points = vtk.vtkPoints()
    for point in POINTS:
        points.InsertNextPoint(point)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetVerts(cells((0,)))
    data.SetPolys(cells((0, 1, 2, 3)))
    data.SetStrips(cells((1, 4, 2)))
    data.GetPointData().SetNormals(numbers(vtk.vtkFloatArray, "Normals", 3, (0, 0, 1) * 5))
    data.GetPointData().AddArray(numbers(vtk.vtkDoubleArray, "thickness", 1, (1, 2, 3, 4, 5)))
    data.GetPointData().AddArray(numbers(vtk.vtkUnsignedCharArray, "seen", 1, (0, 10, 255, 10, 1)))
    data.GetCellData().SetScalars(numbers(vtk.vtkIntArray, "leaflet", 1, (0, 7, 8)))
    return data


def write(writer, path, data, set_up):
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    set_up(writer)
    writer.Write()


def main(folder):
    data = surface()
    for version in (42, 51):
        for name, mode in (("ascii", vtk.VTK_ASCII), ("binary", vtk.VTK_BINARY)):
            write(
                vtk.vtkPolyDataWriter(),
                folder / f"legacy-{version}-{name}.vtk",
                data,
                lambda writer, v=version, m=mode: (writer.SetFileVersion(v), writer.SetFileType(m)),
            )
    for name, set_up in {
        "ascii": lambda writer: writer.SetDataModeToAscii(),
        "binary": lambda writer: (writer.SetDataModeToBinary(), writer.SetCompressorTypeToNone()),
        "appended": lambda writer: writer.SetDataModeToAppended(),
        "appended-raw": lambda writer: (writer.SetDataModeToAppended(), writer.EncodeAppendedDataOff()),
        "binary-lzma": lambda writer: (writer.SetDataModeToBinary(), writer.SetCompressorTypeToLZMA()),
    }.items():
        write(vtk.vtkXMLPolyDataWriter(), folder / f"{name}.vtp", data, set_up)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))

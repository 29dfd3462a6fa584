"""Files as VTK (Debian's python3-vtk9) reads them."""

import vtk

READERS = {".vtk": vtk.vtkPolyDataReader, ".ply": vtk.vtkPLYReader, ".obj": vtk.vtkOBJReader, ".stl": vtk.vtkSTLReader}


MESSAGES = vtk.vtkStringOutputWindow()
vtk.vtkOutputWindow.SetInstance(MESSAGES)
vtk.vtkLogger.SetStderrVerbosity(vtk.vtkLogger.VERBOSITY_OFF)


def complaints(before):
    """What VTK has said since it had said `before`; it goes on reading nevertheless."""
    said = MESSAGES.GetOutput()[len(before) :].strip()
    return [f"VTK says: {' '.join(said.split())[:200]}"] if said else []


def read(path):
    """The vtkPolyData of a file, and what is wrong with the file."""
    before, reader = MESSAGES.GetOutput(), READERS[path.suffix]()
    reader.SetFileName(str(path))
    if path.suffix == ".vtk":
        reader.ReadAllScalarsOn()
    reader.Update()
    return reader.GetOutput(), complaints(before)


def area(data):
    """Of all triangles, mm2."""
    triangles = vtk.vtkTriangleFilter()
    triangles.PassLinesOff()
    triangles.SetInputData(data)
    mass = vtk.vtkMassProperties()
    mass.SetInputConnection(triangles.GetOutputPort())
    mass.Update()
    return mass.GetSurfaceArea()


def cells(data):
    """(number of lines, number of triangles)"""
    return data.GetNumberOfLines(), data.GetNumberOfPolys()


def arrays(data):
    """Names of the data of points and of cells."""
    point, cell = data.GetPointData(), data.GetCellData()
    return (
        {point.GetArrayName(i) for i in range(point.GetNumberOfArrays())},
        {cell.GetArrayName(i) for i in range(cell.GetNumberOfArrays())},
    )


def bounds_of(blocks):
    box, iterator = vtk.vtkBoundingBox(), blocks.NewIterator()
    while not iterator.IsDoneWithTraversal():
        box.AddBounds(iterator.GetCurrentDataObject().GetBounds())
        iterator.GoToNextItem()
    bounds = [0.0] * 6
    box.GetBounds(bounds)
    return bounds


def glb(path):
    """Bounds of the scene as it is shown (metres), and where its animation begins and ends (none: it has none); errors."""
    before, reader = MESSAGES.GetOutput(), vtk.vtkGLTFReader()
    reader.SetFileName(str(path))
    reader.SetFrameRate(10)
    reader.Update()
    shown, played = bounds_of(reader.GetOutput()), []
    if reader.GetNumberOfAnimations() == 1:
        reader.EnableAnimation(0)
        reader.UpdateInformation()
        for seconds in (0.0, reader.GetAnimationDuration(0)):
            reader.UpdateTimeStep(seconds)
            played.append(bounds_of(reader.GetOutput()))
    return shown, played, complaints(before)

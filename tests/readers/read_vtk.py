"""Files as VTK (Debian's python3-vtk9) reads them."""

import vtk
from vtk.util.numpy_support import vtk_to_numpy

READERS = {".vtk": vtk.vtkPolyDataReader, ".ply": vtk.vtkPLYReader, ".obj": vtk.vtkOBJReader, ".stl": vtk.vtkSTLReader}


def errors_of(reader):
    """Collects what VTK complains of; it goes on reading nevertheless."""
    errors = []
    reader.AddObserver("ErrorEvent", lambda source, event: errors.append("VTK finds an error"))
    reader.AddObserver("WarningEvent", lambda source, event: errors.append("VTK warns"))
    return errors


def read(path):
    """The vtkPolyData of a file, and what is wrong with the file."""
    vtk.vtkObject.GlobalWarningDisplayOff()
    reader = READERS[path.suffix]()
    errors = errors_of(reader)
    reader.SetFileName(str(path))
    if path.suffix == ".vtk":
        reader.ReadAllScalarsOn()
    reader.Update()
    return reader.GetOutput(), errors


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData()) if data.GetNumberOfPoints() else []


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
    return ({point.GetArrayName(i) for i in range(point.GetNumberOfArrays())},
            {cell.GetArrayName(i) for i in range(cell.GetNumberOfArrays())})


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
    vtk.vtkObject.GlobalWarningDisplayOff()
    reader = vtk.vtkGLTFReader()
    errors = errors_of(reader)
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
    return shown, played, errors

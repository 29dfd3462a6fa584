"""Meshes in three dimensions: axes of matplotlib, pictures by VTK."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .errors import CoaptError, MissingPackage

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

OBLIQUE = (0.4, -1.0, 0.5)
"""Where a picture is seen from: posterior, a little from the right and from the atrium."""

_COLD, _WARM = (0.23, 0.30, 0.75), (0.71, 0.02, 0.15)  # ends of a diverging map (Moreland 2009)
_TISSUE = (0.91, 0.73, 0.63)
THREAD, RIM = (0.36, 0.23, 0.18), (0.0, 0.45, 0.70)


@dataclass(frozen=True)
class Lines:
    """Drawn beside a mesh as tubes."""

    points_mm: Any
    """L x P x 3: L lines of P points."""
    radius_mm: float
    colour: tuple[float, float, float]


def rim_of(outline_mm: Sequence[Sequence[float]]) -> Any:
    """One line, closed: for Lines."""
    import numpy

    return numpy.array([[*outline_mm, outline_mm[0]]])


def axes_of(mesh: Any, colour: str | None, ax: Axes | None) -> Axes:
    """See Mesh.plot()."""
    try:
        from matplotlib import pyplot
        from mpl_toolkits.mplot3d.art3d import Poly3DCollection
    except ImportError as error:
        raise MissingPackage(
            "a drawing needs matplotlib: pip install matplotlib, or apt install python3-matplotlib"
        ) from error
    axes: Any = pyplot.figure().add_subplot(projection="3d") if ax is None else ax
    triangles = mesh.vertices_mm[mesh.faces]
    drawing = Poly3DCollection(triangles, edgecolor="#ffffff60", linewidth=0.2, facecolor="#9aa3ad")
    if colour is not None:
        drawing.set_array(mesh.cell_data[colour])
        axes.figure.colorbar(drawing, ax=axes, label=colour.replace("_", " "))
    axes.add_collection3d(drawing)
    lower, upper = mesh.vertices_mm.min(axis=0), mesh.vertices_mm.max(axis=0)
    axes.set(**{f"{name}lim": (lower[k], upper[k]) for k, name in enumerate("xyz")})
    axes.set(xlabel="posteromedial, mm", ylabel="anterior, mm", zlabel="to the atrium, mm")
    axes.set_box_aspect(upper - lower)
    axes.view_init(elev=50, azim=-90)
    return axes


def png_of(
    mesh: Any, colour: str | None, lines: Sequence[Lines], seen_from: Sequence[float], size_px: tuple[int, int]
) -> bytes:
    """See Mesh.render()."""
    with ThreadPoolExecutor(1) as pool:  # what OpenGL draws into belongs to a thread: not to one of the caller's
        return pool.submit(_rendered, mesh, colour, lines, seen_from, size_px).result()


def _rendered(
    mesh: Any, colour: str | None, lines: Sequence[Lines], seen_from: Sequence[float], size_px: tuple[int, int]
) -> bytes:
    vtk = _vtk()
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(_surface(vtk, mesh, colour))
    if colour is not None:
        renderer.AddActor2D(_colours(vtk, mapper, mesh.cell_data[colour], colour))
    renderer.AddActor(_actor(vtk, mapper, _TISSUE))
    for some in lines:
        renderer.AddActor(_actor(vtk, _tubes(vtk, some), some.colour))
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*seen_from)
    above = abs(seen_from[2]) > 10 * max(abs(seen_from[0]), abs(seen_from[1]))
    camera.SetViewUp(*((0, 1, 0) if above else (0, 0, 1)))
    renderer.ResetCamera()
    camera.Zoom(1.3)
    with _window(vtk) as window:
        window.SetSize(*size_px)
        window.SetMultiSamples(8)
        window.AddRenderer(renderer)
        window.Render()
        taken = vtk.vtkWindowToImageFilter()
        taken.SetInput(window)
        taken.ReadFrontBufferOff()
        writer = vtk.vtkPNGWriter()
        writer.WriteToMemoryOn()
        writer.SetInputConnection(taken.GetOutputPort())
        writer.Write()
        return bytes(memoryview(writer.GetResult()))


def _vtk() -> Any:
    """:raises MissingPackage: it is not installed"""
    try:
        import vtkmodules.all
    except ImportError as error:
        raise MissingPackage("a picture needs VTK: pip install vtk, or apt install python3-vtk9") from error
    return vtkmodules.all


def _surface(vtk: Any, mesh: Any, colour: str | None) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtk

    surface = _poly_data(vtk, mesh.vertices_mm)
    cells = vtk.vtkCellArray()
    for face in mesh.faces:
        cells.InsertNextCell(3, [int(corner) for corner in face])
    surface.SetPolys(cells)
    if colour is not None:
        surface.GetCellData().SetScalars(numpy_to_vtk(mesh.cell_data[colour].astype(float), deep=True))
    return surface


def _poly_data(vtk: Any, points_mm: NDArray[Any]) -> Any:
    made, points = vtk.vtkPolyData(), vtk.vtkPoints()
    for point in points_mm:
        points.InsertNextPoint(*map(float, point))
    made.SetPoints(points)
    return made


def _tubes(vtk: Any, lines: Lines) -> Any:
    data, cells = _poly_data(vtk, lines.points_mm.reshape(-1, 3)), vtk.vtkCellArray()
    count = lines.points_mm.shape[1]
    for line in range(len(lines.points_mm)):
        cells.InsertNextCell(count, list(range(line * count, (line + 1) * count)))
    data.SetLines(cells)
    tubes = vtk.vtkTubeFilter()
    tubes.SetInputData(data)
    tubes.SetRadius(lines.radius_mm)
    tubes.SetNumberOfSides(10)
    tubes.CappingOn()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(tubes.GetOutputPort())
    return mapper


def _actor(vtk: Any, mapper: Any, colour: tuple[float, float, float]) -> Any:
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetInterpolationToFlat()
    return actor


def _colours(vtk: Any, mapper: Any, values: NDArray[Any], name: str) -> Any:
    """The scale beside the picture: from the 1st to the 99th percentile."""
    ordered = sorted(map(float, values))
    least, most = ordered[len(ordered) // 100], ordered[-1 - len(ordered) // 100]
    colours = vtk.vtkColorTransferFunction()
    colours.SetColorSpaceToDiverging()
    colours.AddRGBPoint(least, *_COLD)
    colours.AddRGBPoint(most if most > least else least + 1.0, *_WARM)
    mapper.SetLookupTable(colours)
    scale = vtk.vtkScalarBarActor()
    scale.SetLookupTable(colours)
    scale.SetTitle(name.replace("_", " ") + "\n ")
    scale.SetNumberOfLabels(5)
    scale.SetLabelFormat("%.2f")
    scale.SetUnconstrainedFontSize(True)
    for text in (scale.GetTitleTextProperty(), scale.GetLabelTextProperty()):
        text.SetColor(0, 0, 0)
        text.SetFontSize(14)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    scale.SetWidth(0.08)
    scale.SetHeight(0.6)
    scale.SetPosition(0.86, 0.2)
    return scale


@contextmanager
def _window(vtk: Any) -> Iterator[Any]:
    """Out of sight. VTK before 9.4 draws into windows of a display alone, so it is given EGL's, which needs none."""
    if hasattr(vtk, "vtkEGLRenderWindow") or hasattr(vtk, "vtkOSOpenGLRenderWindow"):
        window = vtk.vtkRenderWindow()
        window.SetOffScreenRendering(1)
        yield window
        window.Finalize()
        return
    with _egl_context():
        window = vtk.vtkGenericOpenGLRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetReadyForRendering(True)
        window.SetIsCurrent(True)
        shown = vtk.vtkObject.GetGlobalWarningDisplay()
        vtk.vtkObject.GlobalWarningDisplayOff()  # its loader of functions looks for a display, and does without it
        try:
            if not window.InitializeFromCurrentContext():
                raise CoaptError("VTK cannot draw with this machine's OpenGL")
            yield window
        finally:
            window.Finalize()
            vtk.vtkObject.SetGlobalWarningDisplay(shown)


@contextmanager
def _egl_context() -> Iterator[None]:
    """A context of OpenGL that is no window's, current for this thread (EGL 1.5, EGL_KHR_surfaceless_context)."""
    missing = MissingPackage("a picture without a display needs EGL: apt install libegl1 libgl1-mesa-dri")
    os.environ.setdefault("EGL_PLATFORM", "surfaceless")
    try:
        egl = ctypes.CDLL("libEGL.so.1", mode=ctypes.RTLD_GLOBAL)
    except OSError as error:
        raise missing from error
    pointer = ctypes.c_void_p
    for name, kinds in (
        ("eglGetDisplay", [pointer]),
        ("eglInitialize", [pointer] * 3),
        ("eglChooseConfig", [pointer, pointer, pointer, ctypes.c_int, pointer]),
        ("eglCreateContext", [pointer] * 4),
        ("eglMakeCurrent", [pointer] * 4),
        ("eglDestroyContext", [pointer] * 2),
    ):
        getattr(egl, name).argtypes = kinds
    egl.eglGetDisplay.restype = egl.eglCreateContext.restype = pointer
    surface, renderable, opengl, none, version, minor = 0x3033, 0x3040, 0x30A2, 0x3038, 0x3098, 0x30FB
    wanted = (ctypes.c_int * 5)(surface, 0x0001, renderable, 0x0008, none)  # off screen, of OpenGL
    at_least = (ctypes.c_int * 5)(version, 3, minor, 2, none)
    display, config, count = egl.eglGetDisplay(None), pointer(), ctypes.c_int()
    if not egl.eglInitialize(display, None, None) or not egl.eglBindAPI(opengl):
        raise missing
    egl.eglChooseConfig(display, wanted, ctypes.byref(config), 1, ctypes.byref(count))
    context = egl.eglCreateContext(display, config, None, at_least) if count.value else None
    if context is None or not egl.eglMakeCurrent(display, None, None, context):
        raise missing
    try:
        yield
    finally:
        egl.eglMakeCurrent(display, None, None, None)
        egl.eglDestroyContext(display, context)

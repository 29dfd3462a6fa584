"""In the place of Slicer's packages, which cannot be installed here: names that take any call, so that the module can be run as far
as its own mistakes go. What Slicer itself does is asked by the module's self-test alone.
"""

import sys
import types
from unittest.mock import MagicMock

import numpy
import vtk


class OrientedImage(vtk.vtkImageData):
    """vtkOrientedImageData, as far as it is read."""

    def __init__(self):
        self.to_world = numpy.eye(4)

    def GetImageToWorldMatrix(self, matrix):
        for i in range(4):
            for j in range(4):
                matrix.SetElement(i, j, self.to_world[i, j])


class Base:
    """Of the module's classes."""

    def __init__(self, parent=None):
        self.parent, self.layout = parent, MagicMock()

    def setup(self):
        pass

    def addObserver(self, *_):
        pass

    removeObservers = addObserver


class Scene(MagicMock):
    """`added`: class, name and node of what was added."""

    def __init__(self, *arguments, **named):
        super().__init__(*arguments, **named)
        self.added = []

    def AddNewNodeByClass(self, kind, name):
        node = MagicMock(name=name)
        self.added.append((kind, name, node))
        return node


def install():
    """The packages slicer, qt and ctk; returns them."""
    slicer, qt, ctk = MagicMock(), MagicMock(), MagicMock()
    slicer.vtkOrientedImageData = OrientedImage
    slicer.mrmlScene = Scene()
    for package, name in ((qt, "QLabel"), (qt, "QLineEdit"), (qt, "QPushButton"), (qt, "QTableWidget"), (qt, "QComboBox"),
                          (qt, "QSpinBox"), (slicer, "qMRMLNodeComboBox")):  # fmt: skip
        getattr(package, name).side_effect = lambda *_: MagicMock()
    qt.QFormLayout.return_value.rowCount.return_value = 0
    qt.QSettings.return_value.value.side_effect = lambda key, default: default
    base = types.ModuleType("slicer.ScriptedLoadableModule")
    for part in ("", "Logic", "Test", "Widget"):
        setattr(base, f"ScriptedLoadableModule{part}", type(part or "Module", (Base,), {}))
    slicer.util.VTKObservationMixin = type(
        "Mixin", (), {"addObserver": Base.addObserver, "removeObservers": Base.addObserver}
    )
    found = {"slicer": slicer, "qt": qt, "ctk": ctk, "slicer.util": slicer.util, base.__name__: base}
    sys.modules.update(found)
    return slicer, qt, ctk

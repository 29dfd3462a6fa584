"""Saves a closed valve as VTK, reads it with VTK itself, and draws its chordae as thick as they are pulled."""

import numpy
import vtk
from matplotlib import pyplot
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection
from vtk.util.numpy_support import vtk_to_numpy

import coapt

coapt.preset("human-functional-mr").close().save("closed.vtk")
reader = vtk.vtkPolyDataReader()
reader.SetFileName("closed.vtk")
reader.ReadAllScalarsOn()
reader.Update()
mesh = reader.GetOutput()
points = vtk_to_numpy(mesh.GetPoints().GetData())
faces = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
lines = vtk_to_numpy(mesh.GetLines().GetConnectivityArray()).reshape(-1, 2)
tension = vtk_to_numpy(mesh.GetCellData().GetArray("tension_n"))[: len(lines)]  # VTK numbers lines before faces
print(
    f"{len(points)} points, {len(faces)} triangles, {len(lines)} pieces of chordae, the tightest of {tension.max():.1f} N"
)

figure = pyplot.figure(figsize=(6.4, 5))
ax = figure.add_subplot(projection="3d")
ax.add_collection(Poly3DCollection(points[faces], facecolor="#e8b9a0", edgecolor="#b08070", linewidth=0.2, alpha=0.8))
ax.add_collection(Line3DCollection(points[lines], linewidths=0.5 + 2 * tension, colors="#5b3a2e"))
ax.auto_scale_xyz(*points.T)
ax.set_box_aspect(numpy.ptp(points, axis=0), zoom=1.2)
ax.view_init(elev=8, azim=-70)
ax.set_axis_off()
figure.savefig("to_vtk.png")

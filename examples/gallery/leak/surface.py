"""Draws the leak as what it is: the least surface in the blood between the leaflets, in three dimensions."""

import numpy
from matplotlib import pyplot
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import coapt

scene = coapt.engine().scene("human-functional-mr")
points, faces = numpy.reshape(scene["closed_mm"], (-1, 3)), numpy.reshape(scene["faces"], (-1, 3))
figure = pyplot.figure(figsize=(6.4, 4.6))
ax = figure.add_subplot(projection="3d", computed_zorder=False)
ax.add_collection(Poly3DCollection(points[faces], facecolor="#e8b9a0", edgecolor="#b08070", linewidth=0.2, zorder=1))
for part in scene["leak"]:
    corners = numpy.reshape(part["points_mm"], (-1, 3))
    triangles = corners[numpy.reshape(part["faces"], (-1, 3))]
    ax.add_collection(Poly3DCollection(triangles, facecolor="#1437d8", edgecolor="#1437d8", zorder=2))
ax.auto_scale_xyz(*points.T)
ax.set_box_aspect(numpy.ptp(points, axis=0), zoom=1.3)
ax.view_init(elev=55, azim=-90)
ax.set_axis_off()
figure.savefig("surface.png")

"""Follows the closing leaflets through six moments, cut through the middle of both."""

import numpy
from matplotlib import pyplot
from matplotlib.collections import LineCollection

import coapt

scene = coapt.engine().scene("human-functional-mr", frames=6)
faces = numpy.reshape(scene["faces"], (-1, 3))
figure, axes = pyplot.subplots(2, 3, figsize=(8, 4.4), sharex=True, sharey=True)
for number, (frame, ax) in enumerate(zip(scene["motion_mm"], axes.flat), 1):
    points, pieces = numpy.reshape(frame, (-1, 3)), []
    for a, b, c in points[faces]:
        ends = [p + p[0] / (p[0] - q[0]) * (q - p) for p, q in ((a, b), (b, c), (c, a)) if (p[0] < 0) != (q[0] < 0)]
        if ends:
            pieces.append([end[1:] for end in ends])
    ax.add_collection(LineCollection(pieces, colors="#c8372d", linewidths=2.5))
    ax.set(xlim=(-19, 19), ylim=(-21, 5), aspect="equal")
    ax.text(0.04, 0.06, str(number), transform=ax.transAxes, fontsize=14, color="grey")
figure.supylabel("to the atrium, mm")
figure.supxlabel("anterior, mm")
figure.savefig("six_moments.png")

"""Writes the closed leaflets as a label map (NIfTI-1) and draws the slice through the middle of both."""

import gzip
import struct

import numpy
from matplotlib import pyplot

import coapt

coapt.preset("human-functional-mr").close().save("closed.nii.gz")
content = gzip.decompress(open("closed.nii.gz", "rb").read())
sizes = struct.unpack_from("<8h", content, 40)[1:4]
voxel = struct.unpack_from("<8f", content, 76)[1:4]
labels = numpy.frombuffer(content, "u1", offset=352).reshape(sizes, order="F")
middle = labels[sizes[0] // 2].T
figure, ax = pyplot.subplots()
extent = [0, sizes[1] * voxel[1], 0, sizes[2] * voxel[2]]
ax.imshow(numpy.ma.masked_equal(middle, 0), origin="lower", extent=extent, cmap="Set1", interpolation="none")
ax.set(xlabel="mm", ylabel="mm", title=f"{sizes} voxels of {voxel[0]:.2f} mm")
figure.savefig("label_map_out.png")

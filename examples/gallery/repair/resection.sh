# Resects a triangle of the prolapsing P2, supports it with a ring, and writes what 3D Slicer opens beside the picture.
coapt close human-p2-prolapse --plan examples/plans/resection-triangular.json --render resection.png
coapt export human-p2-prolapse --plan examples/plans/resection-triangular.json -o repaired.mrk.json -o repaired.vtk

# Measures how far a valve closed on 650 triangles lies from the same valve closed on 2,600, and draws the distance.
coapt valve make human-functional-mr --triangles 2600 -o fine.json
coapt close fine.json --closed fine.ply > /dev/null
coapt compare human-functional-mr fine.ply --align none --map compare_shapes.png

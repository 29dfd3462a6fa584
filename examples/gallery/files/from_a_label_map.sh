# Draws a label map such as a segmentation leaves, imports it, and draws the valve beside what was given.
examples/scripts/label_map.py -o valve.seg.nrrd
coapt valve import valve.seg.nrrd -o valve.json --render from_a_label_map.png
coapt valve check valve.json

# Closes a preset, says why it leaks, and draws it with a ring, all from the command line.
coapt close human-functional-mr
coapt diagnose human-functional-mr
coapt close human-functional-mr --plan examples/plans/ring.json --render three_commands.png

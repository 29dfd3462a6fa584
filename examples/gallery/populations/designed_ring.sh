# Designs a ring for one valve and draws its outline; the solid for printing and its dimensions are written beside it.
coapt design ring --valve human-functional-mr --evaluations 100 -o designed_ring.json
ls designed_ring.*

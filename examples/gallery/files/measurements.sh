# Writes the figures of a valve as a table under SlicerHeart's names, before and after a ring, beside a picture of it.
coapt export secondary-mr -o before.csv
coapt export secondary-mr --plan examples/plans/own-ring.json -o after.csv
paste -d, before.csv after.csv | cut -c1-100 | head -20
coapt close secondary-mr --plan examples/plans/own-ring.json --render measurements.png > /dev/null

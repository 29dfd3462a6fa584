"""Closes every plan of a batch in processes of its own; a plan that the valve refuses leaves the others their results."""

from concurrent.futures import ProcessPoolExecutor

from matplotlib import pyplot

import coapt

SIZES_MM = [28.0, 30.0, 31.0, 32.0, 34.0, 36.0, 38.0]  # no ring is made in 31 mm


def leak_mm2(size_mm):
    return (
        coapt.preset("human-functional-mr").close(coapt.Plan(coapt.Ring("generic-classic", size_mm))).measure.leak_mm2
    )


if __name__ == "__main__":
    leaks = {}
    with ProcessPoolExecutor(2) as pool:
        for size_mm, asked in [(size_mm, pool.submit(leak_mm2, size_mm)) for size_mm in SIZES_MM]:
            try:
                leaks[size_mm] = asked.result()
            except coapt.InvalidRequest as error:
                print(error.problems[0].message)
    figure, ax = pyplot.subplots()
    ax.plot(leaks.keys(), leaks.values(), "o-")
    ax.set(xlabel="size of the ring, mm", ylabel="leak, mm²", ylim=(0, None))
    figure.savefig("processes.png")

"""Shows how much each chorda carries, in a healthy valve and in a tethered one."""

import numpy
from matplotlib import pyplot

import coapt

figure, ax = pyplot.subplots()
for place, name in enumerate(("human-normal", "human-functional-mr")):
    closure = coapt.preset(name).close()
    order = numpy.argsort(closure.chordae)
    ax.bar(numpy.arange(len(order)) + 0.4 * place, closure.tension_n[order], width=0.4, label=name)
    print(f"{name}: {closure.tension_n.sum():.1f} N in all, most in {closure.chordae[closure.tension_n.argmax()]}")
ax.set_xticks(numpy.arange(len(order)) + 0.2, numpy.array(closure.chordae)[order], rotation=90)
ax.set_ylabel("tension at the papillary head, N")
ax.legend()
figure.savefig("chordal_tension.png")

"""Changes where the tissue stiffens and its thickness, and shows what that does to leak and strain."""

from matplotlib import pyplot

import coapt

valve = coapt.preset("human-functional-mr")
figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.8))
for thickness in (0.7, 1.0, 1.4):
    strains = [0.08, 0.10, 0.12, 0.14, 0.16]
    tissue = [{"radial_extension": strain, "thickness_mm": thickness} for strain in strains]
    measures = [valve.close(tissue=one).measure for one in tissue]
    percent = [100 * strain for strain in strains]
    axes[0].plot(percent, [one.leak_mm2 for one in measures], "o-", label=f"{thickness} mm thick")
    axes[1].plot(percent, [100 * one.strain_radial_max for one in measures], "o-")
axes[0].set(ylabel="leak, mm²", ylim=(0, None))
axes[1].set(ylabel="radial strain, 99th percentile, %", ylim=(0, None))
axes[0].legend()
figure.supxlabel("radial strain at which the tissue stiffens, %")
figure.savefig("stiffness.png")

"""What the laboratory's charts share: colours, titles, legends, columns of a table."""

import pathlib
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("plot.py: needs matplotlib (Debian: python3-matplotlib)")

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402 (after the backend is chosen)
from matplotlib.ticker import FuncFormatter  # noqa: E402

# Okabe and Ito's colours, told apart by every kind of sight.
BLACK, ORANGE, SKY, GREEN = "#000000", "#e69f00", "#56b4e9", "#009e73"
YELLOW, BLUE, VERMILION, PURPLE = "#f0e442", "#0072b2", "#d55e00", "#cc79a7"
GREY = "#5b6670"
PLAIN = FuncFormatter(lambda value, _: f"{value:,.0f}" if value >= 1 else f"{value:g}")


plt.style.use(pathlib.Path(__file__).with_name("plot.mplstyle"))


def each_once(values):
    return list(dict.fromkeys(values))


def numbers(rows, column):
    return [float(row[column]) for row in rows]


def title(figure, text, size=13):
    figure.suptitle(text, x=0.01, ha="left", fontsize=size, fontweight="bold")


def figure_titled(text, width, height, **grid):
    figure, axes = plt.subplots(figsize=(width, height), layout="constrained", **grid)
    title(figure, text)
    return figure, axes


def legend_beside(axis, *handles_and_labels):
    axis.legend(*handles_and_labels, loc="center left", bbox_to_anchor=(1.02, 0.5))

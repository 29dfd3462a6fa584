"""Regret and intervals of learned weights over the number of answers: preference.csv."""

import statistics

from style import BLUE, GREY, VERMILION, each_once, figure_titled

WAYS = (("informative", VERMILION), ("random", BLUE))
NOISES = (("model", "-"), ("flips", "--"))


def draw_preference(rows):
    figure, axes = figure_titled("Weights learned from simulated experts", 9.5, 4.2, ncols=2)
    for asking, colour in WAYS:
        for noise, line in NOISES:
            here = [row for row in rows if row["asking"] == asking and row["noise"] == noise]
            answers = each_once(row["answers"] for row in here)
            by_answers = [[row for row in here if row["answers"] == count] for count in answers]
            numbers = [int(count) for count in answers]
            style = {"color": colour, "ls": line, "label": f"{asking} pairs, noise {noise}"}
            regrets = [statistics.mean(float(row["held_out_regret_mm2"]) for row in group) for group in by_answers]
            informed = [statistics.mean(int(row["informed"]) for row in group) for group in by_answers]
            axes[0].plot(numbers, regrets, **style)
            axes[1].plot(numbers, informed, **style)
    axes[0].axhline(0.0, color=GREY, lw=0.8)
    axes[0].set(xlabel="answers", ylabel="regret on held-out cases, mm²")
    axes[1].set(xlabel="answers", ylabel="weights that answers inform, of 14")
    axes[0].legend(fontsize=8)
    return figure

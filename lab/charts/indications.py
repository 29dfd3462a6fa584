"""In how many settings of the thresholds that rank the first plan of a valve stays the first: indications.csv."""

from style import BLUE, ORANGE, figure_titled

SETTINGS = 27  # threshold_settings() of search/plans/plan_order.h


def draw_indications(rows):
    rows = sorted((row for row in rows if row["first_plan"]), key=lambda row: int(row["times_first"]))
    times = [int(row["times_first"]) for row in rows]
    figure, axis = figure_titled("First plans of valves under 27 settings of the thresholds", 8, 0.24 * len(rows) + 1)
    axis.barh([row["valve"] for row in rows], times, color=[BLUE if n == SETTINGS else ORANGE for n in times])
    axis.set(
        xlim=(0, SETTINGS + 0.5), xlabel="settings in which the first plan stays first (orange: printed as a choice)"
    )
    axis.margins(y=0.01)
    return figure

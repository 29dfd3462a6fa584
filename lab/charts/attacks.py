"""What attacks on the service leave to others, in release 0.2 and now: attacks.csv."""

from style import BLUE, GREY, PLAIN, each_once, figure_titled

WIDTH = 0.38


def draw_attacks(rows):
    figure, (waits, memory) = figure_titled("The service under attack", 8.5, 4.6, ncols=2, sharey=True)
    attacks = each_once(row["attack"] for row in rows)
    for offset, release, color in ((-WIDTH / 2, "0.2", GREY), (WIDTH / 2, "now", BLUE)):
        for axis, column in ((waits, "wait_s"), (memory, "memory_mib")):
            own = [row for row in rows if row["release"] == release and row[column]]
            places = [attacks.index(row["attack"]) + offset for row in own]
            bars = axis.barh(places, [float(row[column]) for row in own], WIDTH, color=color, label=release)
            axis.bar_label(bars, [f"{float(row[column]):,g}" for row in own], padding=2, fontsize="small")
    waits.set_yticks(range(len(attacks)), labels=attacks)
    waits.invert_yaxis()
    for axis, label in ((waits, "another client's wait, s"), (memory, "memory, MiB")):
        axis.set(xscale="log", xlabel=label)
        axis.set_xlim(right=4 * axis.get_xlim()[1])
        axis.xaxis.set_major_formatter(PLAIN)
    waits.legend(loc="lower right")
    return figure

"""Tasks a second of a farm against its workers, and the cost of a task against the size of a run: farm.csv."""

from style import BLUE, GREY, PLAIN, VERMILION, figure_titled

TASK_MS = 200.0


def draw_farm(rows):
    figure, (throughput, cost) = figure_titled("A farm as it grows, on two cores", 9.5, 3.8, ncols=2)
    simulated = [row for row in rows if float(row["task_ms"]) == TASK_MS]
    workers = [int(row["workers"]) for row in simulated]
    ideal = [1000.0 * count / TASK_MS for count in workers]
    throughput.plot(workers, ideal, "-", color=GREY, label="no time lost")
    throughput.plot(workers, [float(row["tasks_per_s"]) for row in simulated], "o-", color=BLUE, label="measured")
    throughput.set(xscale="log", yscale="log", xlabel="workers", ylabel=f"tasks of {TASK_MS:.0f} ms a second")
    throughput.set_xticks(workers, labels=workers)
    throughput.legend(fontsize=8)
    empty = [row for row in rows if float(row["task_ms"]) == 0.0]
    items = [float(row["items"]) for row in empty]
    cost.plot(items, [float(row["ms_per_task"]) for row in empty], "o-", color=VERMILION)
    cost.set(
        xscale="log", yscale="log", xlabel="items of the run, 256 a task", ylabel="ms a task, which computes nothing"
    )
    for axis in (throughput, cost):
        axis.minorticks_off()
        axis.yaxis.set_major_formatter(PLAIN)
    return figure

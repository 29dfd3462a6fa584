"""Tables of the documents, as CSV files."""

import csv


def write_table(path, rows):
    """Rows are dictionaries, at least one: the first one's keys are the columns, and what a later one lacks stays empty."""
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)

"""Tables of the documents, as CSV files."""

import csv


def write_table(path, rows):
    """Rows are dictionaries with the same keys, the columns; at least one."""
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)

#!/usr/bin/env python3
"""check_commits.py: fails if a commit's message is not as .gitmessage says: subject imperative, of at most 72 characters and about one
change; a body that says why. Checked are all commits since FIRST, after which the rule holds."""

import re
import sys

from affected import git

FIRST = "750885d097cef49e74454323afd7aa5fc3638cd0"
# First words that begin no imperative.
NOT_VERBS = """a all also an another as at both by each every fewer for from how in it its less many more most new no none now of on one
only other same several some that the there these they this those three to two under what when where which who with without""".split()
VERBS = "bias bring embed exceed feed focus need proceed seed shed speed string".split()


def complaints(subject, body):
    """What is wrong with a message."""
    first = re.split(r"\W", subject, maxsplit=1)[0]
    if len(subject) > 72:
        yield f"has {len(subject)} characters, 72 at most"
    known = first.lower() in VERBS
    if (
        not re.fullmatch(r"[A-Z][a-z]+", first)
        or first.lower() in NOT_VERBS
        or not known
        and re.search(r"(ed|ing|[^s]s)$", first)
    ):
        yield f'begins with "{first}", must begin with an imperative'
    if re.search(r"[.;]$|; |^\S+:", subject):
        yield "is not one plain sentence without a full stop"
    if not body.strip():
        yield "has no body that says why"


def main():
    wrong = []
    for commit in git("rev-list", "--no-merges", f"{FIRST}..HEAD"):
        subject, _, body = "\n".join(git("show", "-s", "--format=%B", commit)).partition("\n")
        wrong += [f"{commit[:8]} ({subject}): subject {problem}" for problem in complaints(subject, body)]
    print("\n".join(wrong).replace("subject has no body", "has no body"), file=sys.stderr)
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())

"""What a change can break: changed files -> rooms whose code may behave otherwise (the arrows of ARCHITECTURE.md, reversed)."""

import pathlib
import subprocess

from check_includes import arrows

ROOT = pathlib.Path(__file__).resolve().parents[1]


def git(*arguments):
    """Lines of its output; none if it fails."""
    run = subprocess.run(["git", "-C", ROOT, *arguments], capture_output=True, text=True)
    return run.stdout.splitlines() if run.returncode == 0 else []


def usual_base():
    """The commit where the branch left origin/main; None on origin/main itself and where git does not know it."""
    left = git("merge-base", "HEAD", "origin/main")
    return left[0] if left and left != git("rev-parse", "HEAD") else None


def changed_files(since):
    """What differs from the commit `since` in the working tree; None (everything may) if git does not know it."""
    if not since or git("cat-file", "-t", since) != ["commit"]:
        return None
    return [*git("diff", "--name-only", since), *git("ls-files", "--others", "--exclude-standard")]


def room_of(name, rooms):
    """The innermost room that holds the file; None outside of them."""
    folders = [str(folder) for folder in pathlib.PurePath(name).parents]
    return next((folder for folder in folders if folder in rooms), None)


def affected_rooms(files):
    """The rooms of `files` and all whose sources may include theirs, directly or not; a page, a script or a document has none."""
    includes = {room.rstrip("/"): [other.rstrip("/") for other in others] for room, others in arrows()}
    reached = {room_of(name, includes) for name in files if not name.endswith((".md", ".py", ".scd"))} - {None}
    while True:
        more = {
            room
            for room, others in includes.items()
            if room not in reached
            and any(at == other or at.startswith(other + "/") for at in reached for other in others)
        }
        if not more:
            return reached
        reached |= more

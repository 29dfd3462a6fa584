"""Manual pages: scdoc's language into Markdown of MyST.

What docs/man uses of it: sections, bold and underlined words, options with an indented description, lists, literal
blocks, tables, and lines that end with ++ (examples).
"""

import re

from pages import escaped

_PAGE = re.compile(r"\b(coapt(?:-[a-z]+)?)\(1\)")
_CELL = re.compile(r"^([|:])[\[\]<>=-]* *(.*)$")


def manual_page(text):
    """The page, and what its NAME says."""
    title = re.match(r"[\w-]+", text).group()
    what = re.search(r"^# NAME\n+.*? - (.*)$", text, re.MULTILINE)[1]
    blocks = re.split(r"\n\n+", text.strip())[1:]
    return "\n\n".join([f"# {title}", *map(_block, blocks)]) + "\n", what


def _block(block):
    lines = block.splitlines()
    if block.startswith("#"):
        return "\n\n".join([_heading(lines[0]), *([_block("\n".join(lines[1:]))] if lines[1:] else [])])
    if block.startswith("```"):
        return block
    if block.startswith("|"):
        return _table(lines)
    if any(line.endswith("++") for line in lines) or all(line.startswith("\t") for line in lines):
        code = "\n".join(line.strip().removesuffix("++").replace("\\", "") for line in lines)
        return f"```bash\n{code}\n```"
    if block.startswith("- "):
        return "\n".join("- " + _inline(item) for item in block[2:].split("\n- "))
    term, tab, description = block.partition("\n\t")
    if tab:
        return f"{_inline(term)}\n: {_inline(' '.join(description.split()))}"
    return _inline(block)


def _heading(line):
    """A command's synopsis stands below its name."""
    level, words = re.match(r"(#+) (.*)", line).groups()
    name = re.match(r"coapt[\w-]*( [a-z-]+)*(?= |$)", words)
    if level == "##" and name:
        synopsis = words.replace("*", "").replace("\\", "")
        return f"### {name.group()}\n\n```\n{synopsis}\n```"
    return f"#{level} {words.capitalize() if words.isupper() else _inline(words)}"


def _table(lines):
    """A list: what the first column names, and what is said of it."""
    rows = []
    for line in lines:
        mark, cell = _CELL.match(line).groups()
        if mark == "|":
            rows.append([])
        rows[-1].append(_inline(cell))
    return "\n\n".join(f"{row[0]}\n: {' '.join(row[1:])}" for row in rows)


def _inline(text):
    """Bold and underlined words. An underscore inside a word is one."""
    out, bold, slanted, i = [], False, False, 0
    while i < len(text):
        char = text[i]
        inside = 0 < i < len(text) - 1 and text[i - 1].isalnum() and text[i + 1].isalnum()
        if char == "\\" and i + 1 < len(text):
            i += 1
            out.append(escaped(text[i]))
        elif char == "*":
            bold = not bold
            out.append("<b>" if bold else "</b>")
        elif char == "_" and not inside:
            slanted = not slanted
            out.append("<i>" if slanted else "</i>")
        else:
            out.append(escaped(char))
        i += 1
    return _PAGE.sub(r"[\1(1)](\1.md)", "".join(out))

"""A notebook that was run, as Markdown of MyST: its words, its code, and what each cell shows."""

import base64
import json
import re

_ANSI = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


def notebook_page(path):
    """The page, and its pictures by name."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    parts, pictures = [], {}
    for cell in notebook["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            parts.append(source)
            continue
        parts.append(f"```python\n{source}\n```")
        for output in cell["outputs"]:
            parts += _shown(output, f"{path.stem}-{len(pictures) + 1}.png", pictures)
    return "\n\n".join(parts) + "\n", pictures


def _shown(output, name, pictures):
    """The richest form of an output, as Jupyter takes it. Progress on standard error is left out."""
    if output["output_type"] == "stream":
        return [] if output["name"] == "stderr" else [_text("".join(output["text"]))]
    data = output.get("data", {})
    if "image/png" in data:
        pictures[name] = base64.b64decode("".join(data["image/png"]))
        return [f"![What the cell shows]({name})"]
    if "text/html" in data:
        lines = "".join(data["text/html"]).splitlines()
        html = "\n".join(line for line in lines if line.strip())  # Markdown would end it at an empty line
        return [f'<div class="shown">\n{html}\n</div>']
    return [_text("".join(data.get("text/plain", "")))]


def _text(text):
    return f"```text\n{_ANSI.sub('', text).rstrip()}\n```"

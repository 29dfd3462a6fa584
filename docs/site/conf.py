"""The documentation site. Its sources are gathered into build/docs-source (gather.py); make docs does it all."""

import functools
import pathlib
import re
import subprocess
import sys

from docutils import nodes
from pygments.lexers.special import TextLexer

sys.path[:0] = [str(pathlib.Path(__file__).parent), str(pathlib.Path(__file__).parents[2] / "clients/python")]
from pages import NOTICE, ROOT  # noqa: E402

project, author = "coapt", "The coapt authors"
copyright = f"the coapt authors. {NOTICE}"
release = re.search(r"^project\(coapt VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1]
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx_copybutton"]
highlight_language = "text"
smartquotes = False  # options begin with two hyphens
suppress_warnings = ["myst.header"]  # a page may go from its title to a heading of the third level

myst_enable_extensions = ["colon_fence", "deflist", "dollarmath"]
html_math_renderer = "mathml"
myst_heading_anchors = 4

html_theme = "furo"
html_title = f"coapt {release}"
html_static_path = [str(pathlib.Path(__file__).parent / "static")]
html_css_files = ["site.css"]
html_show_sourcelink = False
html_domain_indices = False  # of one package
html_copy_source = False
html_theme_options = {"announcement": NOTICE, "top_of_page_button": None}
copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_type_aliases = {
    name: name for name in ("Valve", "PlanSource", "ShapeSource", "Path", "Status", "JobState", "Document")
}
autodoc_preserve_defaults = True
autodoc_default_options = {"undoc-members": True}
add_module_names = False
ANSWERS = (
    "closures",
    "comparison",
    "estimates",
    "events",
    "evidence",
    "fits",
    "leaks",
    "openings",
    "ranked_plans",
    "results",
    "stored",
    "sweep",
)


def signature_of(app, what, name, thing, options, signature, returned):
    """Answers are not made by a caller, so that how they are made says nothing."""
    module = getattr(thing, "__module__", "").removeprefix("coapt.")
    if what == "class" and module in ANSWERS and thing.__name__ != "Fit":
        return "", None
    return None


@functools.cache
def mathml(formula):
    """As browsers draw it by themselves; `formula` with its dollars."""
    command = ["pandoc", "--from", "markdown", "--to", "html", "--mathml"]
    made = subprocess.run(command, input=formula, capture_output=True, text=True, check=True)
    if made.stderr or "<math" not in made.stdout:
        raise ValueError(f"{formula}: no formula: {made.stderr}")
    return re.search(r"<math.*</math>", made.stdout, re.DOTALL)[0]


def visit_formula(translator, node):
    translator.body.append(mathml(f"${node.astext()}$"))
    raise nodes.SkipNode


def visit_formula_block(translator, node):
    translator.body.append(f'<div class="math">{mathml(f"$${node.astext()}$$")}</div>')
    raise nodes.SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", (visit_formula, None), (visit_formula_block, None))
    for name in ("arrows", "libraries"):  # lists of ARCHITECTURE.md that make includes-check reads
        app.add_lexer(name, TextLexer)
    app.connect("autodoc-process-signature", signature_of)

# Sphinx with MyST: the pages as they are, as a site. Called by scripts/site.
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
project = "Ariadne"
extensions = ["myst_parser"]
root_doc = "README"
include_patterns = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "doc/*.md", "doc/**/*.md",
                    "datasets/*.md", "datasets/**/*.md", "examples/*.md"]
exclude_patterns = ["doc/lab/experiments/results/*/*.md", "build"]
html_theme = "sphinx_rtd_theme"
html_show_copyright = False
html_show_sphinx = False
myst_heading_anchors = 4
suppress_warnings = ["myst.header"]

# The order of pages in the menu. The pages themselves have no directives for it, so that they read the same on GitHub.
ROOMS = {
    "README": ["doc/README", "doc/tutorial/README", "doc/howto/README", "doc/reference/README", "doc/explanation/README",
               "doc/lab/README", "CONTRIBUTING", "CHANGELOG"],
    "doc/reference/README": ["doc/reference/*", "datasets/README", "doc/pictures/worlds/README"],
    "datasets/README": ["datasets/ros/README"],
    "doc/tutorial/README": ["doc/tutorial/*", "examples/README"],
    "doc/lab/benchmarks/README": ["doc/lab/benchmarks/*"],
    "doc/lab/experiments/README": ["doc/lab/experiments/*", "doc/lab/experiments/results/README"],
    "doc/lab/README": ["doc/lab/benchmarks/README", "doc/lab/experiments/README", "doc/lab/*"],
}
for room in ("howto", "explanation"):
    ROOMS[f"doc/{room}/README"] = [f"doc/{room}/*"]


def add_menu(app, page, source):
    if page in ROOMS:
        pages = "\n".join("/" + name for name in ROOMS[page])
        source[0] += f"\n\n```{{toctree}}\n:hidden:\n:glob:\n\n{pages}\n```\n"


def setup(app):
    app.connect("source-read", add_menu)

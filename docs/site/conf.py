"""Settings of Sphinx for the sources that build.py has written."""

import os
from pathlib import Path

project = "whirl"
author = "The whirl developers"
copyright = author
release = os.environ.get("WHIRL_VERSION", "")
version = release
root_doc = "index"
extensions = ["myst_parser", "breathe", "sphinx.ext.mathjax", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
exclude_patterns = ["static"]

myst_enable_extensions = ["dollarmath", "html_image"]
myst_heading_anchors = 4
myst_update_mathjax = False

# Debian's MathJax; build.py copies its files that formulas need, so that no network is used.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML"
mathjax2_config = {"messageStyle": "none", "showMathMenu": False, "CommonHTML": {"linebreaks": {"automatic": True}}}

breathe_projects = {folder.name: str(folder) for folder in Path(os.environ["WHIRL_DOXYGEN"]).iterdir()}
breathe_domain_by_extension = {"h": "c"}

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_type_aliases = {"ArrayLike": "ArrayLike"}  # the alias, not the long union that it names

smartquotes = False
c_extra_keywords = ["bool"]  # "imaginary" is the name of a member

html_theme = "furo"
html_title = f"whirl {release}".strip()
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
# Summaries of search results would be fetched from the pages, which browsers forbid for a site on disk.
html_show_search_summary = False
html_theme_options = {"navigation_with_keys": True}
# Two styles of Pygments whose comments are readable: a contrast above 4.5.
pygments_style = "default"
pygments_dark_style = "github-dark"

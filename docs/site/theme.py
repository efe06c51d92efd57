"""Changes of Debian's furo theme by which its pages work as files on disk.

The theme's script is a module, which browsers do not load from a file: here it is one classic script. Its style sheet
imports normalize.css by a path of Debian's web servers, and has dark colours only for readers who choose them on the
page, not for those whose system is dark. Files in the site's static folder replace files of the theme by name.
"""

import re
from pathlib import Path

import furo

PARTS = Path(furo.__file__).parent / "theme/furo/static"
NORMALIZE = Path("/usr/share/javascript/normalize.css/normalize.css")
DARK = re.compile(r'^  body\[data-theme="dark"\] \{.*?^    body\[data-theme="dark"\] \.only-dark \{.*?\}',
                  re.MULTILINE | re.DOTALL)


def one_script(scripts):
    """Returns the script with the module that it imports, in a scope of their own; unchanged without imports."""
    text = (scripts / "furo.js").read_text()
    imported = re.search(r'^import \w+ from "\./([\w-]+\.js)";\n', text, re.MULTILINE)
    if not imported:
        return text
    return f"{(scripts / imported[1]).read_text()}\n(function () {{\n{text.replace(imported[0], '')}}})();\n"


def dark_where_the_system_is(style):
    """Returns the style sheet with the dark colours a second time, for pages without a choice of light or dark."""
    if "prefers-color-scheme" in style:
        return style
    colours = DARK.search(style)
    if not colours:
        raise RuntimeError("the dark colours of furo.css are not where they were: docs/site/theme.py looks for them")
    automatic = colours[0].replace('body[data-theme="dark"]', 'body:not([data-theme="light"])')
    return f"{style}\n@media screen and (prefers-color-scheme: dark) {{\n{automatic}\n}}\n"


def lay_out(static):
    """Writes the files that replace those of the theme."""
    (static / "scripts").mkdir(parents=True, exist_ok=True)
    (static / "styles").mkdir(exist_ok=True)
    (static / "scripts/furo.js").write_text(one_script(PARTS / "scripts"))
    style = (PARTS / "styles/furo.css").read_text()
    if "@import url(/javascript/normalize.css/normalize.css);" in style:
        style = style.replace("url(/javascript/normalize.css/normalize.css)", "url(normalize.css)")
        (static / "styles/normalize.css").write_text(NORMALIZE.read_text())
    (static / "styles/furo.css").write_text(dark_where_the_system_is(style))

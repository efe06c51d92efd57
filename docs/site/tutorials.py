#!/usr/bin/python3
"""Runs tutorials: Markdown whose blocks of code are the cells of a notebook:  tutorials.py BUILD FILE...

    ```python   is a cell
    ```sh       is a cell of commands (%%bash); one that fails ends the tutorial
    ```octave   is a cell of Octave
    ```yaml     (octave) that begins with "# file: NAME" ("% file: NAME") writes that file
    all others  are shown

Pictures of images/tutorials are for readers of the Markdown; a notebook draws them itself.

Runs every tutorial in a fresh folder with BUILD/whirl on the PATH, and says which cell fails. build.py puts what cells
print and draw into the site.
"""

import base64
import os
import re
import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

ROOT = Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^```(python|sh|octave|yaml)\n(.*?)^```\n", re.MULTILINE | re.DOTALL)
PICTURE = re.compile(r"^!\[[^\]]*\]\(\.\./images/tutorials/[^)]*\)\n", re.MULTILINE)
# Octave 7.3 prints this when it ends, independent of its commands.
OCTAVE_EXIT = "error: ignoring const execution_exception& while preparing to exit\n"
COLOUR = re.compile(r"\x1b\[[0-9;]*m")
MAGIC = {"python": "", "sh": "%%bash -e\n", "octave": "%%script octave-cli --no-gui --quiet\n"}


def cell_source(language, code):
    """Returns the cell for a block, or None if the block is no cell."""
    named = re.match(r"[#%] file: (\S+)\n", code)
    if named:
        return f"%%writefile {named[1]}\n{code[named.end():]}"
    return MAGIC[language] + code if language in MAGIC else None


def read_notebook(text):
    """Returns the notebook of a tutorial."""
    notebook = nbformat.v4.new_notebook()
    notebook.metadata.kernelspec = {"name": "python3", "display_name": "Python 3", "language": "python"}
    text, begin = PICTURE.sub("", text), 0

    def add_words(words):
        if words.strip():
            notebook.cells.append(nbformat.v4.new_markdown_cell(words.strip()))

    for fence in FENCE.finditer(text):
        source = cell_source(fence[1], fence[2])
        if source is None:
            continue
        add_words(text[begin : fence.start()])
        notebook.cells.append(nbformat.v4.new_code_cell(source.rstrip(), metadata={"language": fence[1]}))
        begin = fence.end()
    add_words(text[begin:])
    for number, cell in enumerate(notebook.cells):
        cell.id = f"cell-{number}"
    return notebook


def environment(build):
    """Sets the environment of cells: command and Python package of this build, and one thread, to run all at once."""
    build = Path(build).resolve()
    os.environ["PATH"] = f"{build}:/usr/bin:{os.environ['PATH']}"
    os.environ["PYTHONPATH"] = str(ROOT / "bindings/python")
    os.environ["WHIRL_LIBRARY"] = str(build / "libwhirl.so")
    os.environ["WHIRL_CASES"] = str(ROOT / "cases")
    os.environ["OCTAVE_PATH"] = str(ROOT / "bindings/octave")
    os.environ["OMP_NUM_THREADS"] = "1"
    os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"


def execute(notebook):
    """Runs all cells in a new folder; raises CellExecutionError if one fails."""
    with tempfile.TemporaryDirectory() as folder:
        client = NotebookClient(notebook, timeout=300, kernel_name="python3",
                                resources={"metadata": {"path": folder}})
        client.execute()
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.outputs = [output for output in together(cell.outputs) if output.get("text", "none").strip()]


def together(outputs):
    """Joins outputs that were printed in pieces, and leaves out output that no cell has printed."""
    joined = []
    for output in outputs:
        last = joined[-1] if joined else None
        if last and output.output_type == "stream" and last.output_type == "stream":
            last.text += output.text
        else:
            joined.append(output.copy())
    for output in joined:
        if output.output_type == "stream":
            output.text = output.text.replace(OCTAVE_EXIT, "")
    return joined


def printed(notebook):
    """Returns the output of all cells, to find the reason of a failure."""
    return "".join(output.text for cell in notebook.cells for output in cell.get("outputs", [])
                   if output.output_type == "stream")


def shown(output, picture):
    """Returns an output as Markdown; `picture` is the path for a picture of it."""
    if output.output_type == "stream":
        return f"```{{code-block}} none\n:class: output\n\n{output.text.rstrip()}\n```\n"
    data = output.get("data", {})
    if "image/png" in data:
        picture.write_bytes(base64.b64decode(data["image/png"]))
        return f"![{data.get('text/plain', 'a figure')}]({picture.name})\n"
    if "text/html" in data:
        return f"```{{raw}} html\n{data['text/html']}\n```\n"
    return f"```{{code-block}} none\n:class: output\n\n{data.get('text/plain', '')}\n```\n"


def block(cell):
    """Returns the block of a tutorial from which a cell was made."""
    language = cell.metadata.language
    named = re.match(r"%%writefile (\S+)\n", cell.source)
    if not named:
        return f"```{language}\n{cell.source.removeprefix(MAGIC[language])}\n```\n"
    mark = "#" if language == "yaml" else "%"
    return f"```{language}\n{mark} file: {named[1]}\n{cell.source[named.end():]}\n```\n"


def page(notebook, folder, name):
    """Returns a tutorial with the output of its cells, as Markdown; writes pictures and the notebook next to it."""
    parts = []
    for number, cell in enumerate(notebook.cells):
        if cell.cell_type == "markdown":
            parts.append(cell.source + "\n")
            continue
        parts.append(block(cell))
        for k, output in enumerate(cell.outputs):
            if not cell.source.startswith("%%writefile"):
                parts.append(shown(output, folder / f"{name}-{number}-{k}.png"))
    nbformat.write(notebook, folder / f"{name}.ipynb")
    parts.append(f"---\n\n[This lesson as a notebook]({name}.ipynb)\n")
    return "\n".join(parts)


if __name__ == "__main__":
    environment(sys.argv[1])
    failures = 0
    for path in map(Path, sys.argv[2:]):
        notebook = read_notebook(path.read_text())
        try:
            execute(notebook)
            print(f"{path.name}: runs")
        except CellExecutionError as error:
            failures += 1
            print(f"FAILED: {path.name}\n{printed(notebook)}\n{COLOUR.sub('', str(error))}")
    sys.exit(failures > 0)

"""Runs the Python of a page of the documentation: its blocks that begin with ```python, one after the other.

usage: pvpython RunSnippets.py PAGE.md

They run in an empty folder that has the project's Data. Whatever SurfaceScalars.so they load, it is the one under test.
"""

import os
import sys
import tempfile

from paraview import simple


def python_blocks(page):
    """The blocks with blank lines in place of the text around them, so that line numbers are those of the page."""
    inside = False
    lines = []
    for line in page.splitlines():
        if line.startswith("```"):
            inside = line.strip() == "```python"
            lines.append("")
        else:
            lines.append(line if inside else "")
    return "\n".join(lines)


def load_plugin_under_test():
    load = simple.LoadPlugin

    def replacement(filename, *arguments, **options):
        if os.path.basename(filename) == "SurfaceScalars.so":
            filename = os.environ["SURFACE_SCALARS_PLUGIN"]
        return load(filename, *arguments, **options)

    simple.LoadPlugin = replacement


def main():
    path = os.path.abspath(sys.argv[1])
    with open(path, encoding="utf-8") as file:
        code = python_blocks(file.read())
    if not code.strip():
        sys.exit(f"{path}: expected blocks that begin with ```python, found none")
    load_plugin_under_test()
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(os.environ["SURFACE_SCALARS_DATA"], os.path.join(folder, "Data"))
        os.chdir(folder)
        exec(compile(code, path, "exec"), {"__name__": "__main__"})
        os.chdir(os.path.dirname(path))


main()

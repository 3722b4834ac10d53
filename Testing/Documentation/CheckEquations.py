"""Checks that every file that Documentation/equations.md names exists and holds the functions named beside it.

usage: pvpython CheckEquations.py EQUATIONS.md PROJECT_FOLDER
"""

import os
import re
import sys


def sources(text, folder):
    """The texts of the files named in `text`; 'Core/Fields/Field.h, .cxx' names two."""
    texts = []
    for path, also in re.findall(r"((?:Core/\w+|Filters)/\w+\.(?:h|cxx))(, \.cxx)?", text):
        for name in [path] + ([os.path.splitext(path)[0] + ".cxx"] if also else []):
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                texts.append(file.read())
    return texts


def main():
    page, folder = sys.argv[1:3]
    with open(page, encoding="utf-8") as file:
        text = file.read()
    rows = [line.strip("|").split("|") for line in text.splitlines() if line.startswith("|")]
    claims = [(row[2], row[3]) for row in rows[2:] if len(row) > 3]
    claims += re.findall(r"\((`[^()]*?) in\s+([^()]*?)\)", text)
    checked = 0
    for files, functions in claims:
        if "`" in files:
            files, functions = functions, files
        texts = sources(files, folder)
        for name in re.findall(r"`([\w:]+)`", functions) if texts else []:
            checked += 1
            last = name.split("::")[-1]
            if not any(re.search(rf"\b{last}\b", source) for source in texts):
                sys.exit(f"{page}: expected {name} in {files.strip()}, found it in none of these files")
    if checked < 20:
        sys.exit(f"{page}: expected at least 20 functions to check, found {checked}")
    print(f"{checked} functions are where the page says.")


main()

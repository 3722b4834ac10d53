#!/usr/bin/env python3
"""Combines sources for clang-tidy, which spends most of its time on the headers that all of them include.

usage: tidy-groups.py COMPILE_COMMANDS FOLDER SOURCE...

Writes files that include several of the sources each, and a compile_commands.json for them, into FOLDER. Sources
do not go together where one calls what has the name of something in an unnamed namespace of the other.
"""
import json
import os
import re
import sys

MOST_SOURCES = 8
DEFINITION = re.compile(
    r"^(?:(?:struct|class|enum class|using) (\w+)|\w[\w:<>,&*\[\]. ]* [*&]*(\w+)(?:\(|\{| =|;|$))", re.MULTILINE)


def text_of(source):
    with open(source, encoding="utf-8") as file:
        return file.read()


def hidden_names(text):
    """What is defined in unnamed namespaces, which begin and end at the first column."""
    regions = re.findall(r"^namespace\n\{\n(.*?)^\} // namespace\n", text, re.MULTILINE | re.DOTALL)
    return {name for region in regions for match in DEFINITION.findall(region) for name in match if name}


def called_names(text):
    return set(re.findall(r"\b(\w+)[({]", text))


def target_of(command):
    """What has the same options: CMake's folder for the object files."""
    return re.search(r" -o (\S+)\.dir/", command["command"])[1]  # not every CMake says it in an entry of its own


def grouped(sources, commands):
    groups = []
    for source in sources:
        text = text_of(source)
        hidden, called, target = hidden_names(text), called_names(text), target_of(commands[source])
        for group in groups:
            apart = hidden & (group["hidden"] | group["called"]) or called & group["hidden"]
            if len(group["sources"]) < MOST_SOURCES and not apart and target == group["target"]:
                break
        else:
            group = {"sources": [], "hidden": set(), "called": set(), "target": target}
            groups.append(group)
        group["sources"].append(source)
        group["hidden"] |= hidden
        group["called"] |= called
    return [group["sources"] for group in groups]


def main():
    commands_file, folder, *sources = sys.argv[1:]
    with open(commands_file, encoding="utf-8") as file:
        commands = {entry["file"]: entry for entry in json.load(file)}
    os.makedirs(folder, exist_ok=True)
    entries = []
    for number, group in enumerate(grouped(sources, commands)):
        combined = os.path.join(folder, f"{number}.cxx")
        with open(combined, "w", encoding="utf-8") as file:
            file.writelines(f'#include "{source}" // NOLINT(bugprone-suspicious-include)\n' for source in group)
        first = commands[group[0]]
        entries.append({"directory": first["directory"], "file": combined,
                        "command": first["command"].replace(group[0], combined)})
    with open(os.path.join(folder, "compile_commands.json"), "w", encoding="utf-8") as file:
        json.dump(entries, file, indent=1)


if __name__ == "__main__":
    main()

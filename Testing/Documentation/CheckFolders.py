"""Checks that a folder of Core includes headers of those before it in the list of Core/CMakeLists.txt only.

usage: pvpython CheckFolders.py CORE_FOLDER
"""

import glob
import os
import re
import sys


def main():
    core = sys.argv[1]
    with open(os.path.join(core, "CMakeLists.txt"), encoding="utf-8") as file:
        folders = re.search(r"set\(folders([^)]*)\)", file.read()).group(1).split()
    paths = glob.glob(os.path.join(core, "*", "*.h")) + glob.glob(os.path.join(core, "*", "*.cxx"))
    folder_of = {os.path.basename(path): os.path.basename(os.path.dirname(path)) for path in paths}
    checked = 0
    for path in paths:
        user = folder_of[os.path.basename(path)]
        with open(path, encoding="utf-8") as file:
            headers = re.findall(r'#include "(\w+\.h)"', file.read())
        for header in headers:
            if header in folder_of:
                used = folder_of[header]
                assert folders.index(used) <= folders.index(user), f"{path} includes {header} of {used}"
                checked += 1
    assert checked > len(paths), "expected at least one include per file"
    print(f"{checked} includes in {len(folders)} folders go one way.")


main()

#!/usr/bin/python3
"""Every class, function, enumeration and type of the public headers (libs/*/include) has a docstring, by Doxygen's count.

A struct's sentence speaks for its fields, where their names say the rest, and a parameter's explanation stands in its struct's
visitFields. Functions that C++ itself explains (constructors without arguments, = default, = delete) need none.
Skipped where doxygen is not installed (scripts/install-dependencies --tests).
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(os.environ.get("ARIADNE_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
SKIPPED = 77
SETTINGS = """INPUT = {libs} {namespaces}
FILE_PATTERNS = *.h *.dox
EXCLUDE_PATTERNS = */src/*
RECURSIVE = YES
QUIET = YES
WARN_IF_UNDOCUMENTED = YES
WARN_LOGFILE = {log}
GENERATE_HTML = NO
GENERATE_LATEX = NO
JAVADOC_AUTOBRIEF = YES
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = DEFINE_SERIALIZABLE(a,b)=
"""
WARNING = re.compile(r"(.*?):(\d+): warning: (?:Member|Compound) (.*) is not documented\.")


def undocumented(folder):
    """"libs/x/include/ariadne/x/y.h:12: what" for each."""
    libs = ROOT / "libs"
    namespaces = sorted({name for header in libs.glob("*/include/**/*.h")
                         for name in re.findall(r"^namespace (ariadne[\w:]*) {", header.read_text(), re.M)})
    # A function of a namespace counts for Doxygen only where the namespace itself is documented.
    (folder / "namespaces.dox").write_text("".join(f"/** @namespace {name}\n * Ours. */\n" for name in namespaces))
    (folder / "Doxyfile").write_text(SETTINGS.format(libs=libs, namespaces=folder / "namespaces.dox", log=folder / "log"))
    subprocess.run(["doxygen", "Doxyfile"], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    found = set()
    for line in (folder / "log").read_text().splitlines():
        match = WARNING.fullmatch(line)
        if not match or "(variable)" in match[3] or match[3].startswith(("visitFields(", "forEachSection(")):
            continue
        found.add(f"{pathlib.Path(match[1]).relative_to(ROOT)}:{match[2]}: {match[3]}")
    return sorted(found)


def main():
    if not shutil.which("doxygen"):
        print("doxygen is not installed: skipped")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory(prefix="ariadne-docstrings-") as name:
        found = undocumented(pathlib.Path(name))
    print("\n".join(found))
    sys.exit(f"{len(found)} members have no docstring" if found else 0)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
"""lint.py BUILD_DIR [FILE…]: clang-tidy over the sources of model, widgets, editor and resources.

Sources that are compiled together (see quadrille_unity) are read together. What passed is not read again until one of
its sources, a header of ours that they include, its compiler flags or .clang-tidy change; it is kept in BUILD_DIR/lint.
Jobs: QUADRILLE_JOBS, or all cores.
"""
import concurrent.futures
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

CLANG_TIDY = "clang-tidy-14"
ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("model/", "widgets/", "editor/", "resources/")


def flags_of(command):
    """The flags that matter to the parser, and the object file."""
    words = shlex.split(command)
    while not words[0].startswith("-"):
        words.pop(0)
    flags, target = [], ""
    words = iter(words)
    for word in words:
        if word == "-o":
            target = next(words)
        elif word in ("-c", "-include"):
            next(words)  # precompiled headers are GCC's, and each source includes what it uses
        elif word != "-Winvalid-pch":
            flags.append(word)
    return tuple(flags), target


def dependencies(build):
    """Object file → files it was compiled from, as ninja saw them."""
    listing = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    found, target = {}, None
    for line in listing.splitlines():
        if line.startswith("    "):
            found[target].append(line.strip())
        elif ": #deps" in line:
            target = line.split(":")[0]
            found[target] = []
    return found


class Unit:
    """What the compiler reads at once: a source, or several that one file of the build includes."""

    def __init__(self, entry, build, deps, common):
        self.path = Path(entry["file"])
        self.sources = [self.path]
        if self.path.is_relative_to(build):
            self.sources = [Path(name) for name in re.findall(r'#include "(/.*\.cpp)"', self.path.read_text())]
        self.flags, target = flags_of(entry["command"])
        digest = hashlib.sha256(common)
        for source in self.sources:
            digest.update(source.read_bytes())
        digest.update("\0".join((self.path.name, *self.flags)).encode())
        for dependency in sorted(deps.get(target, [])):
            path = (build / dependency).resolve()
            if path.is_relative_to(ROOT) and not path.is_relative_to(build):
                digest.update(path.read_bytes())
        self.key = digest.hexdigest()[:24] + " " + self.path.name

    def names(self):
        return {str(source.relative_to(ROOT)) for source in self.sources if source.is_relative_to(ROOT)}

    def is_ours(self):
        return any(name.startswith(FOLDERS) for name in self.names())


def tidy(unit, build):
    """Output of clang-tidy, empty when all is well."""
    command = [CLANG_TIDY, f"--config-file={ROOT / '.clang-tidy'}", "--quiet", "--checks=-bugprone-suspicious-include",
               str(unit.path), "--", *unit.flags, "-Wno-unknown-warning-option"]
    result = subprocess.run(command, cwd=build, capture_output=True, text=True)
    return "" if result.returncode == 0 else result.stdout or result.stderr


def main():
    build = Path(sys.argv[1]).resolve()
    chosen = {str(Path(name).resolve().relative_to(ROOT)) for name in sys.argv[2:]}
    version = subprocess.run([CLANG_TIDY, "--version"], capture_output=True, check=True).stdout
    common = version + (ROOT / ".clang-tidy").read_bytes()
    deps = dependencies(build)
    entries = json.loads((build / "compile_commands.json").read_text())
    sources = [entry for entry in entries if Path(entry["file"]).suffix in (".cpp", ".cxx")]
    units = [Unit(entry, build, deps, common) for entry in sources if Path(entry["file"]).exists()]
    units = [unit for unit in units if unit.is_ours()]
    known = set().union(*(unit.names() for unit in units))
    for name in chosen - known:
        sys.exit(f"error: {name} is not compiled, so it cannot be checked")

    (build / "lint").mkdir(exist_ok=True)
    stamps = build / "lint" / "passed"
    passed = set(stamps.read_text().splitlines()) if stamps.exists() else set()
    stamps.write_text("".join(unit.key + "\n" for unit in units if unit.key in passed))
    waiting = [unit for unit in units if (unit.names() & chosen if chosen else unit.key not in passed)]
    failed = False
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("QUADRILLE_JOBS", os.cpu_count()))) as pool:
        for unit, output in zip(waiting, pool.map(lambda unit: tidy(unit, build), waiting)):
            if output:
                print(output, flush=True)
                failed = True
            else:
                with stamps.open("a") as file:
                    file.write(unit.key + "\n")
    print(f"{len(known)} sources, {sum(len(unit.names()) for unit in waiting)} of them checked now")
    sys.exit(failed)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
"""lint.py BUILD_DIR [--quick] [FILE…]: clang-tidy over the sources of model, player, widgets, editor and resources.

The sources of a folder are read together, as most of the time goes into headers: names in unnamed namespaces are unique
within a folder (see quadrille_unity). What these declare is not searched where the build made the module ownsources, which takes less than a third
of the time. What passed is not read again until one of its sources, a header of ours that they include, its compiler flags or
.clang-tidy change; it is kept in BUILD_DIR/lint.
--quick leaves clang's static analyser out.
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
FOLDERS = ("model/", "player/", "widgets/", "editor/", "resources/")


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
        elif word.startswith("-I") and word.endswith("_autogen/include"):
            flags += ["-isystem", word[2:]]  # what moc writes is not ours
        # Warnings are the compiler's matter, and -Werror would make clang's errors; how code is made, which kernels
        # have flags of their own for, says nothing of the sources; parameters are GCC's.
        elif not word.startswith(("-W", "-O", "-f", "--param")):
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
    """What is read at once: the sources of a folder that are of one library and compiled with the same flags."""

    def __init__(self, path, sources, flags):
        self.path = path
        self.sources = sources
        self.flags = flags
        self.headers = set()
        self.key = ""

    def sign(self, common):
        """Makes the key that says what was read."""
        digest = hashlib.sha256(common)
        for path in (*self.sources, *sorted(self.headers)):
            digest.update(path.read_bytes())
        digest.update("\0".join((self.path.name, *self.flags)).encode())
        self.key = digest.hexdigest()[:24] + " " + self.path.name

    def names(self):
        return {str(source.relative_to(ROOT)) for source in self.sources if source.is_relative_to(ROOT)}

    def is_ours(self):
        return any(name.startswith(FOLDERS) for name in self.names())


def units_of(build, folder):
    """All units of the build's compile commands, of files that are to be written into the folder given."""
    deps = dependencies(build)
    units = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = Path(entry["file"])
        if path.suffix not in (".cpp", ".cxx") or not path.exists():
            continue
        flags, target = flags_of(entry["command"])
        sources = [path]
        if path.is_relative_to(build):
            sources = [Path(name) for name in re.findall(r'#include "(/.*\.cpp)"', path.read_text())]
        if not sources:
            continue  # precompiled headers
        if target.startswith("player/") and not sources[0].is_relative_to(ROOT / "player"):
            continue  # a part of the model, which is checked where it belongs
        library = next(part for part in Path(target).parts if part.endswith(".dir")).removesuffix(".dir")
        place = sources[0].parent.relative_to(ROOT if sources[0].is_relative_to(ROOT) else build)
        key = ("_".join(place.parts) + "-" + library, flags)
        if key not in units:
            others = sum(name == key[0] for name, _ in units)
            units[key] = Unit(folder / (key[0] + f"-{others}" * (others > 0) + ".cxx"), [], flags)
        unit = units[key]
        unit.sources += sources
        for dependency in deps.get(target, []):
            header = (build / dependency).resolve()
            if header.is_relative_to(ROOT) and not header.is_relative_to(build):
                unit.headers.add(header)
    return [unit for unit in units.values() if unit.is_ours()]


def tidy(unit, build, quick):
    """Output of clang-tidy, empty when all is well."""
    checks = "-bugprone-suspicious-include" + (",-clang-analyzer-*" if quick else "")
    command = [CLANG_TIDY, f"--config-file={ROOT / '.clang-tidy'}", "--quiet"]
    module = build / "tests" / "ownsources.so"
    if module.exists():
        command.append(f"--load={module}")
        checks += ",quadrille-own-sources"
    command += [f"--checks={checks}", str(unit.path), "--", *unit.flags]
    result = subprocess.run(command, cwd=build, capture_output=True, text=True)
    return "" if result.returncode == 0 else result.stdout or result.stderr


def main():
    build = Path(sys.argv[1]).resolve()
    quick = "--quick" in sys.argv[2:]
    chosen = {str(Path(name).resolve().relative_to(ROOT)) for name in sys.argv[2:] if name != "--quick"}
    version = subprocess.run([CLANG_TIDY, "--version"], capture_output=True, check=True).stdout
    common = version + (ROOT / ".clang-tidy").read_bytes()
    folder = build / "lint"
    folder.mkdir(exist_ok=True)
    units = units_of(build, folder)
    for unit in units:
        unit.sign(common)
        unit.path.write_text("".join(f'#include "{source}"\n' for source in unit.sources))
    known = set().union(*(unit.names() for unit in units))
    for name in chosen - known:
        sys.exit(f"error: {name} is not compiled, so it cannot be checked")

    stamps = folder / ("passed-quick" if quick else "passed")
    passed = set()  # what passed everything passes the quick checks, too
    for file in {stamps, folder / "passed"}:
        passed |= set(file.read_text().splitlines()) if file.exists() else set()
    stamps.write_text("".join(unit.key + "\n" for unit in units if unit.key in passed))
    waiting = [unit for unit in units if (unit.names() & chosen if chosen else unit.key not in passed)]
    waiting.sort(key=lambda unit: -len(unit.sources))  # the longest first, or one core waits for it at the end
    failed = False
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("QUADRILLE_JOBS", os.cpu_count()))) as pool:
        for unit, output in zip(waiting, pool.map(lambda unit: tidy(unit, build, quick), waiting)):
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

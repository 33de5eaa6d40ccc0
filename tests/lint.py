#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
"""lint.py BUILD_DIR [FILE…]: clang-tidy over the sources of model, widgets and editor.

clang-tidy spends most of its time in the headers of Qt, VTK and the standard library, so several sources that are
compiled alike are read as one. A source that passed is not read again until it, a header of ours that it includes,
its compiler flags or .clang-tidy change; what passed is kept in BUILD_DIR/lint. Jobs: QUADRILLE_JOBS, or all cores.
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
BATCH = 24
ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("model/", "widgets/", "editor/")


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


class Source:
    def __init__(self, entry, build, deps, common):
        self.path = Path(entry["file"])
        self.name = str(self.path.relative_to(ROOT))
        self.flags, target = flags_of(entry["command"])
        text = self.path.read_text()
        self.private_names = private_names(text)
        digest = hashlib.sha256(common)
        digest.update("\0".join((self.name, *self.flags, text)).encode())
        for dependency in sorted(deps.get(target, [])):
            path = (build / dependency).resolve()
            if path.is_relative_to(ROOT) and not path.is_relative_to(build):
                digest.update(path.read_bytes())
        self.key = digest.hexdigest()[:24] + " " + self.name


def private_names(text):
    """Names in unnamed namespaces, of file-local functions and macros: sources that share one are not read as one."""
    names, inside = set(), False
    for line in text.splitlines():
        if line == "namespace {":
            inside = True
        elif line == "} // namespace":
            inside = False
        elif line.startswith("#define "):
            names.add(re.match(r"#define (\w+)", line)[1])
        elif (inside or line.startswith("static ")) and line[:1].isalpha():
            declared = re.findall(r"\w+", re.split(r"[({=;:]", re.sub(r"::|<[^()]*>", "", line), maxsplit=1)[0])
            names.update(declared[-1:])
    return names


def batches(sources):
    """Splits sources into groups that can be read as one."""
    groups = []
    for source in sorted(sources, key=lambda s: s.name):
        for group in groups:
            if (group[0].flags == source.flags and len(group) < BATCH
                    and not any(source.private_names & other.private_names for other in group)):
                group.append(source)
                break
        else:
            groups.append([source])
    return groups


class Linter:
    def __init__(self, build):
        self.folder = build / "lint"
        self.folder.mkdir(exist_ok=True)
        self.stamps = self.folder / "passed"

    def tidy(self, group):
        """Output of clang-tidy, empty when all is well."""
        if len(group) == 1:
            path = group[0].path
        else:
            path = self.folder / (hashlib.sha256("".join(s.name for s in group).encode()).hexdigest()[:16] + ".cpp")
            path.write_text("".join(f'#include "{source.path}"\n' for source in group))
        command = [CLANG_TIDY, f"--config-file={ROOT / '.clang-tidy'}", "--quiet",
                   "--checks=-bugprone-suspicious-include", str(path), "--", *group[0].flags,
                   "-Wno-unknown-warning-option"]
        result = subprocess.run(command, cwd=self.folder.parent, capture_output=True, text=True)
        return "" if result.returncode == 0 else result.stdout or result.stderr

    def check(self, group):
        """Complaints about a group; one that cannot be read as one is halved."""
        output = self.tidy(group)
        if not output:
            with self.stamps.open("a") as stamps:
                stamps.write("".join(source.key + "\n" for source in group))
            return ""
        if len(group) > 1 and "[clang-diagnostic-error]" in output:
            half = len(group) // 2
            return self.check(group[:half]) + self.check(group[half:])
        return output


def main():
    build = Path(sys.argv[1]).resolve()
    chosen = {str(Path(name).resolve().relative_to(ROOT)) for name in sys.argv[2:]}
    version = subprocess.run([CLANG_TIDY, "--version"], capture_output=True, check=True).stdout
    common = version + (ROOT / ".clang-tidy").read_bytes()
    deps = dependencies(build)
    sources = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = Path(entry["file"])
        if path.is_relative_to(ROOT) and str(path.relative_to(ROOT)).startswith(FOLDERS) and path.exists():
            source = Source(entry, build, deps, common)
            sources[source.name] = source
    for name in chosen - sources.keys():
        sys.exit(f"error: {name} is not compiled, so it cannot be checked")
    linter = Linter(build)
    passed = set(linter.stamps.read_text().splitlines()) if linter.stamps.exists() else set()
    known = {source.key for source in sources.values()}
    linter.stamps.write_text("".join(key + "\n" for key in sorted(passed & known)))
    waiting = [s for s in sources.values() if s.name in chosen or (not chosen and s.key not in passed)]
    jobs = int(os.environ.get("QUADRILLE_JOBS", os.cpu_count()))
    failed = False
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for output in pool.map(linter.check, batches(waiting)):
            if output:
                print(output, flush=True)
                failed = True
    print(f"{len(sources)} sources, {len(waiting)} of them checked now")
    sys.exit(failed)


if __name__ == "__main__":
    main()

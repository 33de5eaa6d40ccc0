#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
"""translations.py LUPDATE ARGUMENT…: fails when a catalogue lacks strings of the sources, holds ones that the sources
have no more, or leaves one unfinished or with other placeholders than its source. ARGUMENTs are lupdate's."""
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
REMEDY = "cmake --build --preset release --target update_translations, then translate what is unfinished in"


def messages(catalogue):
    """(context, source, comment) → the message."""
    found = {}
    for context in xml.parse(catalogue).getroot().iter("context"):
        for message in context.iter("message"):
            found[context.findtext("name"), message.findtext("source"), message.findtext("comment")] = message
    return found


def placeholders(text):
    return sorted(set(re.findall(r"%L?\d+|\{\w+\}", text)))


def forms(message):
    translation = message.find("translation")
    return [form.text or "" for form in translation.iter("numerusform")] or [translation.text or ""]


def complaints(catalogue, lupdate, arguments):
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder) / catalogue.name
        shutil.copy(catalogue, fresh)
        subprocess.run([ROOT / "translations/lupdate.py", lupdate, "-silent", *arguments, "-ts", fresh], check=True,
                       stderr=subprocess.DEVNULL)
        wanted = messages(fresh)
    held = messages(catalogue)
    for context, source, _ in wanted.keys() - held.keys():
        yield f"lacks {context}: {source!r}"
    for context, source, _ in held.keys() - wanted.keys():
        yield f"holds what the sources have no more, {context}: {source!r}"
    for (context, source, _), message in held.items():
        if not context:
            yield f"has no class for {source!r}: lupdate needs tr() behind the class's own name, not behind another for it"
        if message.find("translation").get("type") is not None or "" in forms(message):
            yield f"leaves unfinished {context}: {source!r}"
        elif any(placeholders(form) != placeholders(source) for form in forms(message)):
            yield f"has other placeholders in {context}: {source!r}"


def main():
    lupdate, *arguments = sys.argv[1:]
    failed = False
    for catalogue in sorted((ROOT / "translations").glob("*.ts")):
        plurals = ["-pluralonly"] if catalogue.stem.endswith("_en") else []
        found = sorted(complaints(catalogue, lupdate, plurals + arguments))
        for complaint in found:
            print(f"error: {catalogue.name} {complaint}")
        if found:
            print(f"remedy: {REMEDY} translations/{catalogue.name}")
            failed = True
    sys.exit(failed)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
"""lupdate.py LUPDATE ARGUMENT…: runs Qt's lupdate with the ARGUMENTs and, besides the sources that they name, with the
sentences of the model. It knows no Qt and marks them with QUADRILLE_MESSAGE(text); all of them get the context
"quadrille", where editor/errors looks them up."""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

MODEL = Path(__file__).resolve().parent.parent / "model"
MARKED = re.compile(r'QUADRILLE_MESSAGE\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)\)')


def main():
    lupdate, *arguments = sys.argv[1:]
    sentences = [text for source in sorted(MODEL.rglob("*.cpp")) for text in MARKED.findall(source.read_text())]
    with tempfile.TemporaryDirectory() as folder:
        gathered = Path(folder) / "modelmessages.cpp"
        gathered.write_text("".join(f'QT_TRANSLATE_NOOP("quadrille", {text});\n' for text in sentences))
        return subprocess.run([lupdate, str(gathered), *arguments], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())

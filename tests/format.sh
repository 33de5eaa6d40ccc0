#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# Fails when a source is not formatted as .clang-format says, lacks the licence header or is longer than it may be.
set -euo pipefail
cd "$(dirname "$0")/.."
mapfile -t files < <(git ls-files -co --exclude-standard -- '*.h' '*.cpp')
status=0
clang-format-14 --dry-run --Werror "${files[@]}" || status=1
for file in "${files[@]}"; do
    if [ "$(sed -n 2p "$file")" != "// SPDX-License-Identifier: MIT" ]; then
        echo "error: $file: the two-line SPDX header is missing"
        status=1
    fi
    lines=$(wc -l <"$file")
    if [ "$lines" -gt 400 ] || { [[ $file == *.h ]] && [ "$lines" -gt 200 ]; }; then
        echo "error: $file: $lines lines; sources hold up to 400, headers up to 200"
        status=1
    fi
done
exit $status

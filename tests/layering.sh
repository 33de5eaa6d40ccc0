#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# Fails when an include points against the layers: editor → widgets, editor → model, nothing else; or when the folders
# of a layer include each other in a circle.
set -euo pipefail
cd "${1:-$(dirname "$0")/..}"
status=0

# forbid FOLDER PATTERN WHY: no file under FOLDER may include what PATTERN matches.
forbid() {
    local found
    found=$(grep -rnE "^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]$2" "$1" --include='*.h' --include='*.cpp' || true)
    [ -z "$found" ] && return
    printf '%s\n%s\n' "error: $3" "$found"
    status=1
}

forbid model '(Q[A-Z]|Qt|vtk|VTK)' "model must not include Qt or VTK"
forbid model '(widgets|editor)/' "model must not include widgets or editor"
forbid widgets '(model|editor)/' "widgets must not include model or editor"
forbid editor '(vtk|VTK)' "VTK belongs into widgets"
found=$(grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"](vtk|VTK)' widgets --include='*.h' || true)
if [ -n "$found" ]; then
    printf '%s\n%s\n' "error: VTK headers belong into sources of widgets, not headers" "$found"
    status=1
fi
# The folders of a layer stand above each other: none includes what includes it.
for layer in model widgets editor; do
    found=$(grep -rE "^#include \"$layer/" "$layer" --include='*.h' --include='*.cpp' |
        sed -E 's|^(.*)/[^/]+:#include "(.*)/[^/]+"|\1 \2|' |
        awk '$1 != $2' | sort -u | tsort 2>&1 >/dev/null || true)
    if [ -n "$found" ]; then
        printf '%s\n%s\n' "error: folders of $layer include each other in a circle" "$found"
        status=1
    fi
done
if grep -nE '(Qt6|VTK|Quadrille::Widgets)' -r model --include=CMakeLists.txt; then
    echo "error: model must not link Qt, VTK or the widgets"
    status=1
fi
exit $status

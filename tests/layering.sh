#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# Fails when an include points against the layers: editor → widgets, editor → model, player → model, nothing else; or when folders
# include others than cmake/folders.txt says.
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
forbid player '(Q[A-Z]|Qt|vtk|VTK|widgets/|editor/)' "player must not include Qt, VTK, widgets or editor"
forbid widgets '(model|editor)/' "widgets must not include model or editor"
forbid editor '(vtk|VTK)' "VTK belongs into widgets"
found=$(grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"](vtk|VTK)' widgets --include='*.h' || true)
if [ -n "$found" ]; then
    printf '%s\n%s\n' "error: VTK headers belong into sources of widgets, not headers" "$found"
    status=1
fi
# What the table of folders says is so: each stands below those that include it, and includes those that it names.
table=cmake/folders.txt
declared=$(awk '/^[a-z]/ { folder = $1 } /^ / { for (i = 2; i <= NF; ++i) print folder, $1 "/" $i }' $table | sort)
included=$(grep -rE '^[[:space:]]*#[[:space:]]*include "(model|widgets|editor)/' model widgets editor player --include='*.h' --include='*.cpp' |
    sed -E 's|^(.*)/[^/]+:[^"]*"(.*)/[^/]+"|\1 \2|' | awk '$1 != $2' | sort -u)
# complain TEXT LINES: an error for some lines, if there are any.
complain() {
    [ -z "$2" ] && return
    printf '%s\n%s\n' "error: $1" "$2"
    status=1
}
complain "$table names, below a folder, one that does not stand above it in the list" "$(awk '
    /^[a-z]/ { known[folder] = 1; folder = $1 }
    /^ / { for (i = 2; i <= NF; ++i) if (!($1 "/" $i in known)) print folder, $1 "/" $i }' $table)"
complain "folders include others that $table does not name" "$(comm -13 <(echo "$declared") <(echo "$included") |
    while read -r folder used; do grep -rnE "^[[:space:]]*#[[:space:]]*include \"$used/[^/]+\"" "$folder"/*.*; done)"
complain "$table names folders that are not included" "$(comm -23 <(echo "$declared") <(echo "$included"))"
complain "folders with sources and those of $table differ" "$(comm -3 <(grep -E '^[a-z]' $table | sort) \
    <(find model widgets editor player \( -name '*.h' -o -name '*.cpp' \) -printf '%h\n' | sort -u))"
if grep -nE '(Qt6|VTK|Quadrille::Widgets)' -r model --include=CMakeLists.txt; then
    echo "error: model must not link Qt, VTK or the widgets"
    status=1
fi
exit $status

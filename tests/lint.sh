#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# lint.sh BUILD_DIR [FILE…]: clang-tidy over the project's sources. A file that passed is not read again until it, a
# header of ours or the configuration changes.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
shift
cd "$root"
passed=$build/lint
mkdir -p "$passed"
common=$( (cat .clang-tidy; git ls-files -co --exclude-standard -- '*.h' | sort | xargs cat) | sha256sum | cut -c1-16)

check() {
    local file=$1 stamp
    stamp=$passed/$(printf '%s' "$file" | tr / _).$2.$(sha256sum <"$file" | cut -c1-16)
    [ -e "$stamp" ] && return 0
    local output
    if ! output=$(clang-tidy-14 -p "$build" --quiet "$file" 2>/dev/null); then
        printf '%s\n' "$output"
        return 1
    fi
    touch "$stamp"
}
export -f check
export passed build

if [ $# -eq 0 ]; then
    mapfile -t files < <(git ls-files -co --exclude-standard -- 'model/*.cpp' 'widgets/*.cpp' 'editor/*.cpp')
else
    files=("$@")
fi
printf '%s\n' "${files[@]}" | xargs -P "${QUADRILLE_JOBS:-$(nproc)}" -I{} bash -c "check {} $common"

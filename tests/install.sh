#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# install.sh BUILD_DIR [editor]: installs into a folder of its own; fails when something is not where a system looks for
# it, when an installed program needs a library that it does not find, or when the headless one does not run from there.
set -euo pipefail
tests=$(cd "$(dirname "$0")" && pwd)
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
cmake --install "$1" --prefix "$prefix" >"$prefix/log"
status=0
expected=(bin/quadrille share/quadrille/schema/quadrille-project.schema.json share/doc/quadrille/copyright
    include/quadrille_player.h share/doc/quadrille/player/perform.c)
programs=("$prefix/bin/quadrille")
if [ "${2:-}" = editor ]; then
    expected+=(bin/quadrille-editor share/applications/quadrille.desktop share/metainfo/quadrille.metainfo.xml
        share/mime/packages/quadrille.xml share/icons/hicolor/scalable/apps/quadrille.svg
        share/icons/hicolor/scalable/mimetypes/application-x-quadrille.svg
        share/doc/quadrille/help/en/index.md share/doc/quadrille/help/fr/index.md)
    programs+=("$prefix/bin/quadrille-editor")
fi
for file in "${expected[@]}"; do
    [ -s "$prefix/$file" ] || { echo "error: $file is not installed"; status=1; }
done
"$tests/linkage.sh" "${programs[@]}" || status=1
for program in "${programs[@]}"; do
    if ldd "$program" | grep 'not found'; then
        echo "error: $program misses libraries"
        status=1
    fi
    if readelf -d "$program" | grep -E 'R(UN)?PATH'; then
        echo "error: $program looks for libraries in a build folder"
        status=1
    fi
done
(cd / && "$prefix/bin/quadrille" --version && "$prefix/bin/quadrille" --quiet sample "$prefix/written") || status=1
exit $status

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# run.sh PROGRAM ARGUMENT…: runs a program on a private display under a window manager. Says “skipped” (77) where
# there is none.
set -euo pipefail
if ! command -v openbox >/dev/null; then
    echo "openbox is not installed."
    exit 77
fi
if [ "${1:-}" != --inside ]; then
    exec xvfb-run -a -s "-screen 0 2560x1440x24" "$0" --inside "$@"
fi
shift

here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
openbox --config-file "$here/openbox.xml" --startup "touch $folder/ready" 2>"$folder/messages" &
manager=$!
trap 'kill $manager 2>/dev/null || true; rm -rf "$folder"' EXIT
until [ -e "$folder/ready" ]; do
    kill -0 $manager || { cat "$folder/messages"; exit 1; }
    sleep 0.1
done
"$@"

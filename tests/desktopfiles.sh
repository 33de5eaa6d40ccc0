#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# Fails when the desktop file, the AppStream description or the MIME type is not as the desktops want them; 77: no tools.
set -euo pipefail
cd "$(dirname "$0")/../resources/desktop"
for tool in desktop-file-validate appstreamcli update-mime-database; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
status=0
problems=$(desktop-file-validate quadrille.desktop 2>&1) && [ -z "$problems" ] || { echo "$problems"; status=1; }
appstreamcli validate --no-net --no-color quadrille.metainfo.xml || status=1
data=$(mktemp -d)
mime=$data/mime
trap 'rm -rf "$data"' EXIT
mkdir -p "$mime/packages"
cp quadrille.xml "$mime/packages/"
problems=$(XDG_DATA_DIRS=$data PKGSYSTEM_ENABLE_FSYNC=0 update-mime-database "$mime" 2>&1) && [ -z "$problems" ] || { echo "$problems"; status=1; }
grep -qx 'application/x-quadrille:\*.quadrille' "$mime/globs" || { echo "error: *.quadrille has no type"; status=1; }
exit $status

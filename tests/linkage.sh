#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# linkage.sh QUADRILLE [EDITOR]: fails when a program loads Qt 5 or FFmpeg, when the headless one loads any Qt or VTK, or when
# one links a GPL library directly.
set -euo pipefail
status=0
forbid() {
    local found
    found=$("$1" "$2" | grep -iE "$3" || true)
    [ -z "$found" ] && return
    printf 'error: %s %s\n%s\n' "$2" "$4" "$found"
    status=1
}
loaded() { ldd "$1"; }
direct() { readelf -d "$1" | grep NEEDED; }
for program in "$@"; do
    forbid loaded "$program" 'libQt5' "loads Qt 5"
    forbid loaded "$program" 'libavcodec|libx264|libxvidcore' "loads FFmpeg, which Debian builds under the GPL"
    forbid direct "$program" 'cholmod|umfpack|igraph|x264|qcustomplot|Qt6Charts|CGAL' "links a GPL library"
done
forbid loaded "$1" 'libQt|libvtk' "is headless and must load neither Qt nor VTK"
exit $status

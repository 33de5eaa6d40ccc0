#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# Fails when two types of one namespace share a name: programs that link both behave as nobody wrote (the one
# definition rule). Types in unnamed namespaces and inside others are left out.
set -euo pipefail
cd "$(dirname "$0")/.."
git ls-files -co --exclude-standard -z -- '*.h' '*.cpp' ':!tests' | xargs -0 awk '
    FNR == 1 { depth = 0 }
    /^namespace/ {
        name = ($2 == "{") ? "unnamed" : $2
        spaces[++depth] = name
        next
    }
    /^} \/\/ namespace/ { if (depth > 0) --depth; next }
    /^(class|struct|union|enum class|enum) [A-Za-z_]/ && !/;$/ {
        space = ""
        for (i = 1; i <= depth; ++i) {
            if (spaces[i] == "unnamed")
                next
            space = space spaces[i] "::"
        }
        word = ($2 == "class" || $2 ~ /^alignas/) ? $3 : $2
        if (word ~ /::|</) # one inside another, or a specialisation, which has the name of its template
            next
        sub(/[:{].*/, "", word)
        full = space word
        place = FILENAME ":" FNR
        if (full in seen) {
            print "error: " place ": " full " is defined at " seen[full] ", too; rename one"
            status = 1
        } else
            seen[full] = place
    }
    END { exit status }
'

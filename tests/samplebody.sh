#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# The sample's bodies in resources/sample/body are made by the sources in resources/sample/maker.
# samplebody.sh check             fails when one or the other has changed since `samplebody.sh record`
# samplebody.sh record            writes down what there is now; ./dev body does so after making the bodies
# samplebody.sh remake BUILD_DIR  builds the maker, runs it, and fails when it makes other files
set -euo pipefail
body=$(cd "$(dirname "$0")/../resources/sample/body" && pwd)
cd "$body"
export LC_ALL=C # one order of names everywhere

# The files, and the code that their bytes depend on most, whatever its comments say.
sums() {
    local source
    sha256sum figures.cbor ./*.png
    for source in ../maker/*.h ../maker/*.cpp ../../../model/sample/{noise.h,surfacemesh.cpp,texelmap.cpp}; do
        sed -E 's@(^|[[:space:]]+)//.*$@@; /^[[:space:]]*$/d' "$source" | sha256sum | sed "s@-\$@$source@"
    done
}

case ${1:-} in
    check)
        if ! diff SHA256SUMS <(sums); then
            echo "error: the sample's bodies may not be what their sources make; run ./dev body"
            exit 1
        fi
        ;;
    record) sums >SHA256SUMS ;;
    remake)
        made=$(mktemp -d)
        trap 'rm -rf "$made"' EXIT
        cmake --build "$2" --target sample_body >&2
        "$2/bin/sample_body" "$made"
        diff -r --exclude SHA256SUMS "$body" "$made"
        ;;
    *)
        echo "Usage: samplebody.sh check|record|remake BUILD_DIR" >&2
        exit 2
        ;;
esac

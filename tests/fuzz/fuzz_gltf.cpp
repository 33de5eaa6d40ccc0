// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/gltf/gltf.h"
#include "tests/fuzz/fuzzfile.h"

using namespace quadrille;

/// Anything but a sequence or an Error is a bug.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    SourceFiles source;
    source.path = fuzzFile(data, size, ".glb");
    source.files = {source.path};
    try {
        const ImportResult result = GltfImporter().open(source, {}, {});
        for (const MeshSequence& sequence : result.sequences)
            sequence.frame(FrameIndex(sequence.frameCount() - 1));
    } catch (const Error&) {
    }
    return 0;
}

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/assimpscene.h"
#include "tests/fuzz/fuzzfile.h"

using namespace quadrille;

/// Anything but a sequence or an Error is a bug; so is a file that Assimp does not bear.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    SourceFiles source;
    source.path = fuzzFile(data, size, ".dae");
    source.files = {source.path};
    try {
        const ImportResult result = ColladaImporter().open(source, {}, {});
        for (const MeshSequence& sequence : result.sequences)
            sequence.frame(FrameIndex(sequence.frameCount() - 1));
    } catch (const Error&) {
    }
    return 0;
}

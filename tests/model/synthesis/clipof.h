// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/sample.h"
#include "model/synthesis/clips/clip.h"

#include <stdexcept>
#include <string>

namespace quadrille::test {

/// A sequence as a clip of captured frames.
inline Clip clipOf(const MeshSequence& sequence)
{
    Clip clip{
        .topology = sequence.topology, .fps = sequence.fps, .positions = loadFrames(sequence), .origins = {}};
    for (NodeIndex f = 0; f < sequence.frameCount(); ++f)
        clip.origins.push_back({f, f, 0, false});
    return clip;
}

inline const SampleCharacter& sample()
{
    static const SampleCharacter character = makeSampleCharacter({.textureSize = 64});
    return character;
}

inline const MeshSequence& sampleTake(const std::string& name)
{
    for (const SampleTake& take : sample().takes) {
        if (take.sequence.name == name)
            return take.sequence;
    }
    throw std::out_of_range(name);
}

} // namespace quadrille::test

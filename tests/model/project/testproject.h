// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/file.h"
#include "model/project/document/findentry.h"
#include "model/project/document/project.h"
#include "model/project/fields/pictureoptions.h"
#include "tests/model/core/temporaryfolder.h"

#include <gtest/gtest.h>
#include <string>

namespace quadrille::test {

inline CharacterEntry characterOf(std::string name, std::string mesh)
{
    CharacterEntry character;
    character.name = std::move(name);
    character.mesh = std::move(mesh);
    return character;
}

inline SequenceEntry sequenceOf(std::string name, std::string source)
{
    SequenceEntry sequence;
    sequence.name = std::move(name);
    sequence.source = std::move(source);
    return sequence;
}

inline TextureReference textureOf(TextureReference::Kind kind, std::vector<std::string> paths)
{
    TextureReference texture;
    texture.kind = kind;
    texture.paths = std::move(paths);
    return texture;
}

} // namespace quadrille::test

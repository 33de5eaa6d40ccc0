// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/buildappearance.h"
#include "model/project/steps/appearancetraining.h"
#include "model/project/steps/buildstep.h"
#include "model/project/steps/flowfiles.h"

#include <filesystem>
#include <memory>

namespace quadrille {

/// What the steps about a model of appearance share.
struct AppearanceWork
{
    std::shared_ptr<SequenceOpener> opener;
    AppearanceEntry entry;
    std::filesystem::path projectFile;

    /// Where its files lie, and scratch files while it is made.
    std::filesystem::path folder() const;
    /// The begin of a step about the model.
    BuildStep step(std::string name) const;
    WrittenFile written(const std::filesystem::path& file, const Progress& progress) const;
    /// As the entry wants the model; the reference is left to be found.
    BuildAppearanceOptions options() const;
    /// What is known of forward warps, by the content of textures and of the layout that they are computed
    /// by. \throws Error what reading the textures throws, Cancelled.
    FlowFiles flows(const AppearanceTraining& training, const Progress& progress = {}) const;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/motionspace.h"
#include "model/project/media/opensequence.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// What an entry of “motion_spaces” is computed from. Safe from any thread.
class MotionSpaceWork
{
public:
    /// Of the steps that make motion spaces, see BuildStep::version.
    static constexpr int version = 3;

    /// \param opener  of a project that has the entry.
    MotionSpaceWork(std::shared_ptr<SequenceOpener> opener, MotionSpaceEntry entry);

    const MotionSpaceEntry& entry() const { return m_entry; }
    const std::string& character() const { return m_character; }
    UpAxis up() const { return project().settings.axes.up; }

    /// All spaces of a character are laid onto one pose of it by one part of its body, that in which its
    /// parts are drawn: else one could not go over to another without a turn.
    /// \throws Error ProjectInvalid (what the entry lacks), what opening the sequences throws, as
    /// cutIntoParts, findSymmetry and makeMotionSpace; Cancelled.
    MotionSpace make(const Progress& progress) const;
    /// Of the character. \throws Error what opening a take throws. \pre There is a take.
    std::shared_ptr<const Topology> topology(const Progress& progress) const;

    /// For BuildStep::files.
    std::vector<std::filesystem::path> files(const Progress& progress) const;
    /// All that the space depends on beside files, as text; not what it is called by.
    std::string settings() const;
    /// The steps of clips that takes are.
    std::vector<std::string> inputs() const;

private:
    const Project& project() const { return m_opener->project(); }
    /// The takes, and that which has the pose of the template.
    std::vector<std::string> sequences() const;
    NamedFrame templateFrame() const;
    SpaceTakeSource opened(const SpaceTakeEntry& take, const Progress& progress) const;
    std::vector<SpaceParameter> parameters(std::uint32_t vertices) const;

    std::shared_ptr<SequenceOpener> m_opener;
    MotionSpaceEntry m_entry;
    std::string m_character;
    BodyPartsEntry m_parts;
};

/// As the file has it.
std::string toText(SpaceMeasure measure);

} // namespace quadrille

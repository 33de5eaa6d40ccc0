// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"
#include "model/project/media/opensequence.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// What a transfer is computed from, for the step that makes it and those that measure it.
class TransferWork
{
public:
    /// Of the steps that make transfers, and of those that measure them, see BuildStep::version.
    static constexpr int version = 7;

    TransferWork(std::shared_ptr<SequenceOpener> opener, TransferEntry entry);

    const TransferEntry& entry() const { return m_entry; }
    SequenceOpener& opener() const { return *m_opener; }
    std::string clipName() const { return "transfers/" + m_entry.name; }
    std::string character() const;

    /// Of all sequences, for BuildStep::files. \throws Error as SequenceOpener::filesOf.
    std::vector<std::filesystem::path> files(const Progress& progress) const;
    /// All that the result depends on beside files and clips; what it is called by is not in it.
    std::string settings() const;
    /// The steps of the clips that are needed.
    std::vector<std::string> inputs() const;

private:
    const Project& project() const { return m_opener->project(); }
    /// The target's, the template's, and the clip's own.
    std::vector<std::string> sequences() const;

    std::shared_ptr<SequenceOpener> m_opener;
    TransferEntry m_entry;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/model/project/stripproject.h"

namespace quadrille::test {

/// The strips, and another one that takes over what they do.
class TransferProject : public StripProject
{
protected:
    TransferProject()
    {
        folder.write("scan.obj", bentStrip(0.01, 2));
        project.characters = {characterOf("strip", ""), characterOf("scan", "")};
        project.sequences.push_back(sequenceOf("scan", "scan.obj"));
        project.sequences.back().character = "scan";
        TransferEntry entry;
        entry.name = "slowly";
        entry.clip = "sequences/slow";
        entry.target = {"scan", FrameIndex(0)};
        for (std::uint32_t t = 0; t < 8; ++t)
            entry.pairs.push_back({TriangleIndex(t), TriangleIndex(t)});
        entry.correctsContacts = false; // a strip has no feet
        project.transfers = {entry};
    }

    TransferEntry& transfer() { return project.transfers.front(); }
    SequenceOpener opener() { return {project, folder.path(), cacheFolder(folder / "p.quadrille")}; }
    std::string failure(const std::string& target = "transfers")
    {
        for (const StepReport& step : run(target).steps) {
            if (step.error)
                return step.error->what();
        }
        return "";
    }
};

} // namespace quadrille::test

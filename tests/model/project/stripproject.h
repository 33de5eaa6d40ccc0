// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/project/results/projectdata.h"
#include "model/project/results/rebuild.h"
#include "model/project/store/dataitem.h"
#include "model/transition/characterframes.h"
#include "model/transition/transitiontable.h"
#include "tests/model/project/testproject.h"

#include <cmath>

namespace quadrille::test {

/// A strip of eight triangles that bends to and fro.
/// \param x  where it begins.
inline std::string bentStrip(double angle, double x = 0)
{
    std::string text;
    double y = 0;
    double direction = 0;
    for (int row = 0; row < 5; ++row) {
        for (const int z : {0, 1})
            text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
        x += std::cos(direction);
        y += std::sin(direction);
        direction += angle;
    }
    for (int row = 1; row < 8; row += 2) {
        const auto corner = [&](int i) { return std::to_string(row + i) + " "; };
        text += "f " + corner(0) + corner(1) + corner(3) + "\nf " + corner(0) + corner(3) + corner(2) + "\n";
    }
    return text;
}

/// A project of two short sequences of the strip, and what its steps computed.
class StripProject : public ::testing::Test
{
protected:
    StripProject()
    {
        for (int f = 0; f < 14; ++f)
            folder.write("slow/f_" + std::to_string(f) + ".obj", bentStrip(0.3 * std::sin(0.35 * f)));
        for (int f = 0; f < 9; ++f)
            folder.write("quick/f_" + std::to_string(f) + ".obj", bentStrip(0.35 * std::sin(0.7 * f + 0.1)));
        project.settings.fps = 6; // windows of 2 to 12 frames
        project.sequences = {sequenceOf("slow", "slow"), sequenceOf("quick", "quick")};
    }
    RebuildReport run(const std::string& target)
    {
        return rebuild(project, folder / "p.quadrille", {.targets = {target}});
    }
    DataItem item(const std::string& name)
    {
        for (const DataItem& found : projectData(project, folder / "p.quadrille")) {
            if (found.name == name)
                return found;
        }
        ADD_FAILURE() << "no data " << name;
        return {};
    }
    DataTable table(const std::string& name) { return std::get<DataTable>(item(name).content); }
    template <typename Value>
    std::vector<Value> column(const std::string& table, const std::string& name)
    {
        for (const DataArray& column : this->table(table).columns) {
            if (column.name != name)
                continue;
            if constexpr (std::is_same_v<Value, std::string>)
                return std::get<TextColumn>(column.values).list();
            else
                return std::get<std::vector<Value>>(column.values);
        }
        ADD_FAILURE() << "no column " << name;
        return {};
    }
    Table<float> matrix(const std::string& name)
    {
        const DataItem found = item(name);
        const auto& array = std::get<DataArray>(found.content);
        if (const auto* counts = std::get_if<SharedTable<std::uint16_t>>(&array.values))
            return (**counts == 0).select(TransitionTable::none, (**counts).cast<float>());
        return *std::get<SharedTable<float>>(array.values);
    }
    std::vector<std::string> computed(const RebuildReport& report)
    {
        std::vector<std::string> names;
        for (const StepReport& step : report.steps) {
            EXPECT_NE(step.state, StepState::Failed) << step.error->what();
            if (step.state == StepState::Computed)
                names.push_back(step.step);
        }
        return names;
    }
    CharacterFrames frames()
    {
        SequenceOpener opener(project, folder.path());
        const std::vector<MeshSequence> sequences{opener.open("slow", {})->sequence,
                                                  opener.open("quick", {})->sequence};
        return CharacterFrames(sequences);
    }

    TemporaryFolder folder;
    Project project;
};

} // namespace quadrille::test

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/model/project/stripproject.h"
#include "tests/model/variation/tubewalk.h"

namespace quadrille::test {

/// A project of takes of a tube that sways and walks, and a motion space of two of them.
class WalkProject : public StripProject
{
protected:
    WalkProject()
    {
        project.settings.fps = 25;
        project.sequences.clear();
        addTake("slow", {});
        addTake("fast", {.period = 16, .step = 0.05, .size = 1.6});
        project.motionSpaces = {spaceOf("walk", {"slow", "fast"})};
    }

    void addTake(const std::string& name, const TubeWalk& walk)
    {
        const std::vector<std::string> files = walkFiles(walk);
        for (std::size_t f = 0; f < files.size(); ++f)
            folder.write(name + " walk/f_" + std::to_string(100 + f) + ".obj", files[f]);
        project.sequences.push_back(sequenceOf(name, name + " walk"));
    }

    static MotionSpaceEntry spaceOf(const std::string& name, const std::vector<std::string>& takes)
    {
        MotionSpaceEntry entry;
        entry.name = name;
        for (const std::string& take : takes)
            entry.takes.emplace_back().sequence = take;
        if (takes.size() > 1)
            entry.parameters.emplace_back().name = "speed";
        entry.tolerance = 0.01;
        return entry;
    }

    MotionSpaceEntry& walk() { return project.motionSpaces.front(); }

    /// What the first step that fails says.
    std::string failure(const std::string& target = "motion_spaces")
    {
        for (const StepReport& step : run(target).steps) {
            if (step.error)
                return step.error->what();
        }
        return "";
    }
};

} // namespace quadrille::test

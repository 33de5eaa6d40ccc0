// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/model/project/spacesofwalks.h"
#include "tests/model/project/stripproject.h"

namespace quadrille::test {

/// A project of takes of a tube that sways and walks, and a motion space of two of them.
class WalkProject : public StripProject
{
protected:
    WalkProject()
    {
        project.settings.fps = 25;
        project.sequences.clear();
        addTake("slow", slowWalk);
        addTake("fast", fastWalk);
        project.motionSpaces = {spaceOf("walk", {"slow", "fast"})};
    }

    void addTake(const std::string& name, const TubeWalk& walk)
    {
        writeWalk(folder / (name + " walk"), walk);
        project.sequences.push_back(sequenceOf(name, name + " walk"));
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

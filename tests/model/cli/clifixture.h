// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/file/projectfile.h"
#include "model/project/json/jsontext.h"
#include "tests/model/cli/runquadrille.h"
#include "tests/model/onejoint.h"

#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace quadrille::test {

/// A square of two triangles that rises by a tenth in each of six frames.
inline void writeObjSeries(const TemporaryFolder& folder)
{
    for (int f = 0; f < 6; ++f) {
        const std::string y = "0." + std::to_string(f);
        std::string text;
        for (const char* corner : {"0 Y 0", "1 Y 0", "1 Y 1", "0 Y 1"}) {
            text += "v ";
            for (const char* c = corner; *c != 0; ++c)
                text += *c == 'Y' ? y : std::string(1, *c);
            text += '\n';
        }
        text += "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 3/3 2/2\nf 1/1 4/4 3/3\n";
        folder.write("frames/up_" + std::to_string(f + 8) + ".obj", text);
    }
}

class Cli : public ::testing::Test
{
protected:
    Outcome run(const std::vector<std::string>& arguments) const
    {
        return runCopied(arguments, folder.path());
    }
    Json info(const std::vector<std::string>& paths) const
    {
        std::vector<std::string> arguments{"info", "--json"};
        arguments.insert(arguments.end(), paths.begin(), paths.end());
        const Outcome result = run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(result.out);
    }
    void importSeries() const
    {
        writeObjSeries(folder);
        const Outcome imported = run({"import", "p.quadrille", "frames", "--name", "rise", "--fps", "10"});
        ASSERT_EQ(imported.status, 0) << imported.err;
    }
    /// Adds exports to p.quadrille.
    void addExport(const std::string& name, const std::string& path) const
    {
        Project project = loadProject(folder / "p.quadrille");
        ExportEntry entry;
        entry.name = name;
        entry.what = "sequences/rise";
        entry.path = path;
        project.exports.push_back(entry);
        saveProject(project, folder / "p.quadrille");
    }

    /// A motion of one joint.
    void writeBvh(const std::string& name, int frames, const char* frameTime) const
    {
        folder.write(name, test::oneJointBvh(frames, frameTime));
    }

    TemporaryFolder folder;
};

} // namespace quadrille::test

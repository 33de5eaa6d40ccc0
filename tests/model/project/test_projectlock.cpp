// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/file/projectfile.h"
#include "model/project/file/projectlock.h"
#include "model/project/media/importsequences.h"
#include "tests/model/project/testproject.h"
#include "tests/model/withoutroot.h"

#include <sys/wait.h>

using namespace quadrille;
using namespace quadrille::test;
using State = ProjectLock::State;
namespace fs = std::filesystem;

namespace {

/// The number of a process that ran and is no more.
pid_t goneProcess()
{
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

std::string lockText(const std::string& host, std::int64_t process)
{
    return R"({"program": "quadrille-editor", "user": "ada", "host": ")" + host + R"(", "process": )" +
           std::to_string(process) + R"(, "since": 1700000000, "process_start": "1", "id": "x"})";
}

std::string thisHost()
{
    char name[256] = {};
    ::gethostname(name, sizeof(name) - 1);
    return name;
}

} // namespace

TEST(ProjectLock, OneHoldsItAndTheNextLearnsWho)
{
    const TemporaryFolder folder;
    const auto file = folder / "p.quadrille";
    {
        const ProjectLock first(file, "one");
        EXPECT_EQ(first.state(), State::Held);
        const ProjectLock second(file, "two");
        ASSERT_EQ(second.state(), State::Foreign);
        EXPECT_EQ(second.holder()->program, "one");
        EXPECT_EQ(second.holder()->process, ::getpid());
        EXPECT_EQ(second.holder()->host, thisHost());
        EXPECT_FALSE(second.holder()->isGone());
    }
    EXPECT_TRUE(fs::is_empty(folder.path()));
    EXPECT_EQ(ProjectLock(file, "three").state(), State::Held);
}

TEST(ProjectLock, WhoeverLosesItNotices)
{
    const TemporaryFolder folder;
    const auto file = folder / "p.quadrille";
    ProjectLock first(file, "one");
    ProjectLock second(file, "two");
    second.takeOver();
    EXPECT_EQ(second.state(), State::Held);
    EXPECT_EQ(first.look(), State::Foreign);
    EXPECT_EQ(first.holder()->program, "two");
    first.takeOver();
    EXPECT_EQ(second.look(), State::Foreign);
    fs::remove(ProjectLock::fileOf(file));
    EXPECT_EQ(first.look(), State::Held) << "its file went, nobody has it";
    EXPECT_TRUE(fs::exists(ProjectLock::fileOf(file)));
}

TEST(ProjectLock, ALockOfAProcessThatIsGoneIsTaken)
{
    const TemporaryFolder folder;
    const auto file = folder / "p.quadrille";
    writeAtomically(ProjectLock::fileOf(file), lockText(thisHost(), goneProcess()));
    EXPECT_EQ(ProjectLock(file, "one").state(), State::Held);
    // The number lives on in another process: this one began at another time.
    writeAtomically(ProjectLock::fileOf(file), lockText(thisHost(), ::getpid()));
    EXPECT_EQ(ProjectLock(file, "one").state(), State::Held);
}

TEST(ProjectLock, NobodyKnowsOfProcessesElsewhere)
{
    const TemporaryFolder folder;
    const auto file = folder / "p.quadrille";
    writeAtomically(ProjectLock::fileOf(file), lockText("elsewhere", goneProcess()));
    EXPECT_EQ(ProjectLock(file, "one").state(), State::Foreign);
    writeAtomically(ProjectLock::fileOf(file), "no JSON");
    EXPECT_EQ(ProjectLock(file, "one").state(), State::Foreign);
}

TEST(ProjectLock, ALinkIsLockedAsTheFileItNames)
{
    const TemporaryFolder folder;
    folder.write("p.quadrille", "{}");
    fs::create_symlink(folder / "p.quadrille", folder / "link.quadrille");
    const ProjectLock first(folder / "p.quadrille", "one");
    EXPECT_EQ(ProjectLock(folder / "link.quadrille", "two").state(), State::Foreign);
}

TEST(ProjectLock, AFolderThatCannotBeWrittenIsReadOnly)
{
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                                       fs::perms::others_exec);
    const WithoutRoot plain;
    if (!plain.isPlain())
        GTEST_SKIP() << "root cannot be left here";
    EXPECT_EQ(ProjectLock(folder / "p.quadrille", "one").state(), State::ReadOnly);
}

TEST(ProjectLock, ImportingIntoAnOpenProjectIsRefusedUnlessAskedFor)
{
    const TemporaryFolder folder;
    const auto mesh = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto file = folder / "p.quadrille";
    const ProjectLock editor(file, "quadrille-editor");
    ImportRequest request{.sources = {mesh}};
    try {
        importSequences(file, request);
        FAIL() << "written";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::BadArgument);
        EXPECT_FALSE(fs::exists(file));
    }
    request.ignoresLock = true;
    importSequences(file, request);
    EXPECT_EQ(loadProject(file).sequences.size(), 1U);
    EXPECT_TRUE(fs::exists(ProjectLock::fileOf(file))) << "the editor's stays";
}

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/contenthash.h"
#include "model/core/mediacache.h"
#include "model/project/json/jsontext.h"
#include "model/project/results/rebuild.h"
#include "model/project/store/resultplaces.h"
#include "model/project/store/resultstore.h"
#include "tests/model/project/testproject.h"

#include <atomic>
#include <fstream>
#include <gmock/gmock.h>
#include <thread>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace {

/// A chain a → b → c and a lone d, each counting its runs. `a` and `d` read files.
class Steps
{
public:
    explicit Steps(const TemporaryFolder& folder) : m_folder(folder)
    {
        folder.write("a.txt", "a");
        folder.write("d.txt", "d");
    }

    std::vector<BuildStep> make()
    {
        return {step("a", "a.txt", {}), step("b/one", "", {"a"}), step("b/two", "", {"b/one"}),
                step("d", "d.txt", {})};
    }
    std::vector<int> takeRuns()
    {
        std::vector<int> runs;
        for (std::atomic<int>& count : m_runs)
            runs.push_back(count.exchange(0));
        return runs;
    }

    int version = 1;
    std::string settings;
    std::string failing;

private:
    BuildStep step(const std::string& name, const std::string& file, std::vector<std::string> inputs)
    {
        BuildStep step;
        step.name = name;
        step.version = version;
        step.settings = name == "b/one" ? settings : "";
        if (!file.empty())
            step.files = [path = m_folder / file](const Progress&) { return std::vector{path}; };
        step.inputs = std::move(inputs);
        const std::size_t index = name == "a" ? 0 : name == "b/one" ? 1 : name == "b/two" ? 2 : 3;
        step.compute = [this, index, name, from = step.inputs](const StepContext& context, const Progress&) {
            ++m_runs.at(index);
            if (name == failing)
                throw Error(ErrorCode::BadArgument, {{}, {}, {{"reason", "It failed"}, {"remedy", ""}}});
            std::vector<std::string> words{name};
            for (const std::string& input : from) {
                const auto result = context.resultOf(input);
                const auto& earlier = std::get<TextColumn>(result->arrays.at(0).values);
                words.insert(words.end(), earlier.begin(), earlier.end());
            }
            Result result;
            result.arrays = {columnOf("words", "", std::move(words))};
            return result;
        };
        return step;
    }

    const TemporaryFolder& m_folder;
    std::array<std::atomic<int>, 4> m_runs{};
};

class Rebuild : public ::testing::Test
{
protected:
    RebuildReport run(RebuildOptions options = {})
    {
        return rebuild(steps.make(), folder / "p.quadrille", options, {}, {});
    }
    std::filesystem::path resultOf(const std::string& step) const
    {
        return ResultStore(cacheFolder(folder / "p.quadrille")).fileOf(step);
    }

    TemporaryFolder folder;
    Steps steps{folder};
};

} // namespace

TEST_F(Rebuild, ComputesEverythingOnceAndNothingTwice)
{
    EXPECT_EQ(run().count(StepState::Computed), 4U);
    EXPECT_THAT(steps.takeRuns(), ElementsAre(1, 1, 1, 1));
    const Result last = readResultFile(resultOf("b/two"));
    EXPECT_THAT(std::get<TextColumn>(last.arrays[0].values), ElementsAre("b/two", "b/one", "a"));
    EXPECT_EQ(run().count(StepState::Fresh), 4U);
    EXPECT_THAT(steps.takeRuns(), ElementsAre(0, 0, 0, 0));
}

TEST_F(Rebuild, TakesWhatAStepMakesAlongWithItsOwn)
{
    std::vector<BuildStep> all = steps.make();
    BuildStep& leader = all[0];
    BuildStep& other = all[3];
    leader.along = {other.name, "none of these"};
    leader.compute = [compute = leader.compute](const StepContext& context, const Progress& progress) {
        EXPECT_FALSE(context.isWanted("none of these"));
        if (context.isWanted("d"))
            context.give("d", Result{.arrays = {columnOf("words", "", std::vector<std::string>{"given"})}});
        return compute(context, progress);
    };
    const auto runOf = [&](const RebuildOptions& options) {
        return rebuild(all, folder / "p.quadrille", options, {}, {});
    };
    const auto words = [&] { return std::get<TextColumn>(readResultFile(resultOf("d")).arrays[0].values); };
    const RebuildReport report = runOf({});
    EXPECT_EQ(report.count(StepState::Computed), 4U);
    EXPECT_THAT(steps.takeRuns(), ElementsAre(1, 1, 1, 0));
    EXPECT_THAT(words(), ElementsAre("given"));
    EXPECT_EQ(runOf({}).count(StepState::Fresh), 4U);
    // Where the first is there already, or not asked for, the other is made by itself.
    folder.write("d.txt", "other");
    runOf({});
    EXPECT_THAT(steps.takeRuns(), ElementsAre(0, 0, 0, 1));
    EXPECT_THAT(words(), ElementsAre("d"));
    runOf({.targets = {"d"}, .force = true});
    EXPECT_THAT(steps.takeRuns(), ElementsAre(0, 0, 0, 1));
    // And where the first fails.
    steps.failing = "a";
    leader.compute = [](const StepContext&, const Progress&) -> Result {
        throw Error(ErrorCode::BadArgument, {{}, {}, {{"reason", "It failed"}, {"remedy", ""}}});
    };
    const RebuildReport failed = runOf({.force = true});
    EXPECT_EQ(failed.count(StepState::Failed), 1U);
    EXPECT_THAT(steps.takeRuns(), ElementsAre(0, 0, 0, 1));
}

TEST_F(Rebuild, ChangedContentReachesWhatUsesIt)
{
    run();
    steps.takeRuns();
    folder.write("a.txt", "other");
    run();
    EXPECT_THAT(steps.takeRuns(), ElementsAre(1, 1, 1, 0));
}

TEST_F(Rebuild, ATouchedFileOfTheSameContentIsNoChange)
{
    run();
    steps.takeRuns();
    folder.write("a.txt", "a");
    run();
    EXPECT_THAT(steps.takeRuns(), ElementsAre(0, 0, 0, 0));
}

TEST_F(Rebuild, ChangedSettingsAndVersionsAreStale)
{
    run();
    steps.takeRuns();
    steps.settings = "alpha 3";
    run();
    EXPECT_THAT(steps.takeRuns(), ElementsAre(0, 1, 1, 0));
    steps.version = 2;
    run();
    EXPECT_THAT(steps.takeRuns(), ElementsAre(1, 1, 1, 1));
}

TEST_F(Rebuild, TargetsBringTheirInputs)
{
    RebuildOptions options;
    options.targets = {"b/one"};
    run(options);
    EXPECT_THAT(steps.takeRuns(), ElementsAre(1, 1, 0, 0));
    options.targets = {"b"};
    run(options);
    EXPECT_THAT(steps.takeRuns(), ElementsAre(0, 0, 1, 0));
    options.targets = {"nothing"};
    try {
        run(options);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::ProjectUnknownTarget);
        EXPECT_THAT(error.what(), HasSubstr("a, b, b/one, b/two, d"));
    }
}

TEST_F(Rebuild, ADryRunOnlySaysWhatItWouldDo)
{
    RebuildOptions options;
    options.dryRun = true;
    const RebuildReport report = run(options);
    EXPECT_EQ(report.count(StepState::Stale), 4U);
    EXPECT_EQ(report.steps[0].reason, "there is no result yet");
    EXPECT_THAT(steps.takeRuns(), ElementsAre(0, 0, 0, 0));
    EXPECT_FALSE(std::filesystem::exists(cacheFolder(folder / "p.quadrille")));
}

TEST_F(Rebuild, ForceComputesWhatIsFresh)
{
    run();
    steps.takeRuns();
    RebuildOptions options;
    options.force = true;
    options.targets = {"d"};
    run(options);
    EXPECT_THAT(steps.takeRuns(), ElementsAre(0, 0, 0, 1));
}

TEST_F(Rebuild, ADamagedResultIsComputedAgainWithAWarning)
{
    run();
    steps.takeRuns();
    const std::string before = textOf(resultOf("b/one"));
    folder.write("p.quadrille.cache/b/one.h5", before.substr(0, before.size() / 2));
    const RebuildReport report = run();
    EXPECT_THAT(steps.takeRuns(), ElementsAre(0, 1, 0, 0));
    ASSERT_EQ(report.steps[1].issues.size(), 1U);
    EXPECT_THAT(report.steps[1].issues[0].toString(), HasSubstr("damaged"));
    EXPECT_EQ(textOf(resultOf("b/one")), before);
}

TEST_F(Rebuild, AFailureStopsOnlyWhatNeedsIt)
{
    steps.failing = "b/one";
    const RebuildReport report = run();
    EXPECT_EQ(report.steps[0].state, StepState::Computed);
    EXPECT_EQ(report.steps[1].state, StepState::Failed);
    EXPECT_EQ(report.steps[2].state, StepState::Skipped);
    EXPECT_EQ(report.steps[3].state, StepState::Computed);
    EXPECT_TRUE(report.hasFailures());
    EXPECT_THAT(toJson(report)["stages"][1]["error"].get<std::string>(), HasSubstr("It failed"));
    steps.failing.clear();
    steps.takeRuns();
    EXPECT_EQ(run().count(StepState::Computed), 2U);
    EXPECT_THAT(steps.takeRuns(), ElementsAre(0, 1, 1, 0));
}

TEST_F(Rebuild, AMissingInputFailsWithItsName)
{
    std::filesystem::remove(folder / "a.txt");
    const RebuildReport report = run();
    EXPECT_EQ(report.steps[0].state, StepState::Failed);
    EXPECT_THAT(report.steps[0].error->what(), HasSubstr("a.txt"));
    EXPECT_EQ(report.steps[2].state, StepState::Skipped);
    EXPECT_EQ(report.steps[3].state, StepState::Computed);
}

TEST_F(Rebuild, AChangedOutputFileIsWrittenAgain)
{
    int runs = 0;
    BuildStep step;
    step.name = "exports/e";
    step.compute = [&](const StepContext&, const Progress&) {
        ++runs;
        folder.write("out.txt", "content");
        Result result;
        result.files = {{"out.txt", hashFile(folder / "out.txt")}};
        return result;
    };
    const auto again = [&] { return rebuild(std::vector{step}, folder / "p.quadrille", {}, {}, {}); };
    again();
    EXPECT_EQ(again().count(StepState::Fresh), 1U);
    folder.write("out.txt", "meddled");
    EXPECT_THAT(again().steps[0].reason, HasSubstr("out.txt"));
    std::filesystem::remove(folder / "out.txt");
    again();
    EXPECT_EQ(runs, 3);
    EXPECT_EQ(textOf(folder / "out.txt"), "content");
}

TEST_F(Rebuild, CancellingLeavesNothingHalfWritten)
{
    CancelToken token;
    BuildStep step;
    step.name = "slow";
    step.compute = [&](const StepContext&, const Progress& progress) {
        token.cancel();
        progress.report(0.5);
        return Result{};
    };
    try {
        rebuild(std::vector{step}, folder / "p.quadrille", {}, Progress(token), {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    }
    EXPECT_FALSE(std::filesystem::exists(resultOf("slow")));
}

TEST_F(Rebuild, KeepsToTheMemoryOfTheSettings)
{
    const auto budget = [] { return MediaCache::shared()->statistics().budget; };
    Project project;
    project.settings.cacheMegabytes = 7;
    rebuild(project, folder / "p.quadrille");
    EXPECT_EQ(budget(), std::size_t{7} << 20U);
    project.settings = {};
    rebuild(project, folder / "p.quadrille");
    EXPECT_EQ(budget(), MediaCache::defaultBudget);
}

TEST_F(Rebuild, ManyStepsGiveTheSameBytesForAnyNumberOfThreads)
{
    std::vector<BuildStep> many;
    for (int i = 0; i < 40; ++i) {
        BuildStep step;
        step.name = "many/" + std::to_string(i);
        if (i >= 10)
            step.inputs = {"many/" + std::to_string(i - 10)};
        step.compute = [i, inputs = step.inputs](const StepContext& context, const Progress&) {
            double sum = i;
            for (const std::string& input : inputs)
                sum += std::get<std::vector<double>>(context.resultOf(input)->arrays[0].values)[0];
            Result result;
            result.arrays = {columnOf("sum", "", std::vector<double>{sum})};
            return result;
        };
        many.push_back(std::move(step));
    }
    RebuildOptions one;
    one.jobs = 1;
    EXPECT_EQ(rebuild(many, folder / "one.quadrille", one, {}, {}).count(StepState::Computed), 40U);
    EXPECT_EQ(rebuild(many, folder / "all.quadrille", {}, {}, {}).count(StepState::Computed), 40U);
    for (const BuildStep& step : many) {
        EXPECT_EQ(textOf(ResultStore(cacheFolder(folder / "one.quadrille")).fileOf(step.name)),
                  textOf(ResultStore(cacheFolder(folder / "all.quadrille")).fileOf(step.name)));
    }
}

TEST(FileHashes, RememberSettledFilesOnly)
{
    const TemporaryFolder folder;
    const auto file = folder.write("a", "first");
    {
        FileHashes hashes(folder / "memo.json");
        const std::string first = hashes.of(file);
        folder.write("a", "other");
        EXPECT_NE(hashes.of(file), first);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    FileHashes hashes(folder / "memo.json");
    const std::string known = hashes.of(file);
    hashes.save();
    EXPECT_TRUE(std::filesystem::exists(folder / "memo.json"));
    EXPECT_EQ(FileHashes(folder / "memo.json").of(file), known);
    folder.write("memo.json", "{ broken");
    EXPECT_EQ(FileHashes(folder / "memo.json").of(file), known);
}

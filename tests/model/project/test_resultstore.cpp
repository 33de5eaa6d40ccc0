// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/charactersteps.h"
#include "model/project/store/carryresults.h"
#include "model/project/store/resultplaces.h"
#include "model/project/store/resultstore.h"
#include "tests/model/project/testproject.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

using namespace quadrille;
using namespace quadrille::test;

namespace {

Result fullResult()
{
    DataArray matrix;
    matrix.name = "pose-distance";
    matrix.description = "Distances – metres.";
    matrix.unit = "m";
    matrix.shape = {2, 3};
    matrix.values = SharedTable<float>((Table<float>(2, 3) << 0, 1, INFINITY, 3, 4.5F, -0.0F).finished());
    matrix.columns = {"a", "b", "c"};
    DataArray empty = columnOf("nothing", "", std::vector<double>{});
    DataArray picture;
    picture.name = "picture";
    picture.shape = {1, 2, 4};
    picture.values = std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 255};
    DataArray counts;
    counts.name = "windows";
    counts.unit = "frame";
    counts.shape = {1, 2, 2};
    counts.values = SharedTable<std::uint16_t>((Table<std::uint16_t>(1, 4) << 1, 0, 3, 65535).finished());
    Result result;
    result.arrays = {matrix, empty, picture, counts};
    result.tables = {{"frames",
                      "All frames.",
                      {columnOf("index", "", std::vector<std::int64_t>{0, 1}),
                       columnOf("sequence", "", std::vector<std::string>{"größe", ""})}}};
    result.files = {{"out/a.ply", "00ff"}, {"out/b.ply", "11"}};
    return result;
}

std::vector<std::string> linesOf(const std::filesystem::path& file)
{
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

ErrorCode codeOfReading(const std::filesystem::path& file)
{
    try {
        readResultFile(file);
    } catch (const Error& error) {
        return error.code();
    }
    return ErrorCode::Cancelled;
}

} // namespace

TEST(ResultFile, GivesBackWhatWasWritten)
{
    const TemporaryFolder folder;
    writeResultFile(folder / "r.h5", {"stage", "key"}, fullResult());
    EXPECT_EQ(readResultFile(folder / "r.h5"), fullResult());
    const ResultHeader header = readResultHeader(folder / "r.h5");
    EXPECT_EQ(header.step, "stage");
    EXPECT_EQ(header.key, "key");
}

TEST(ResultFile, LeavesLargeTablesInTheFile)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "large.h5";
    const Table<float> distances = Table<float>::Random(2100, 2100);
    const Table<std::uint16_t> windows = (distances.abs() * 1000.0F).cast<std::uint16_t>().replicate(1, 2);
    DataArray pairs;
    pairs.name = "windows";
    pairs.shape = {2100, 2100, 2};
    pairs.values = SharedTable<std::uint16_t>(windows);
    Result written;
    written.arrays = {matrixOf("pose-distance", "Distances.", "m", distances), pairs};
    const auto isMapped = [&] {
        return std::ranges::count_if(linesOf("/proc/self/maps"), [&](const std::string& line) {
            return line.find(file.string()) != std::string::npos;
        });
    };
    writeResultFile(file, {"stage", "key"}, written);
    {
        const Result read = readResultFile(file);
        EXPECT_EQ(isMapped(), 2);
        EXPECT_EQ(read, written);
        writeResultFile(file, {"stage", "key"}, fullResult());
        EXPECT_EQ(read, written); // they are those that were read
    }
    EXPECT_EQ(isMapped(), 0);
}

/// They are packed and unpacked a part at a time.
TEST(ResultFile, GivesBackMoreTextsThanFitInAPart)
{
    const TemporaryFolder folder;
    const auto file = folder / "texts.h5";
    TextColumn texts;
    for (int i = 0; i < 300000; ++i)
        texts.push_back("frame " + std::to_string(i % 7000));
    DataArray square = columnOf("square", "", texts.list());
    square.shape = {300, 1000};
    Result result;
    result.arrays = {std::move(square)};
    result.tables = {
        {"edges", "Ends.", {columnOf("end", "", texts.list()), columnOf("other", "", texts.list())}}};
    writeResultFile(file, {"graph/edges", "k1"}, result);
    EXPECT_EQ(readResultFile(file), result);
}

TEST(ResultFile, HasTheSameBytesWheneverItIsWritten)
{
    const TemporaryFolder folder;
    writeResultFile(folder / "a.h5", {"stage", "key"}, fullResult());
    ::usleep(1100000); // HDF5 keeps whole seconds where it keeps times
    writeResultFile(folder / "b.h5", {"stage", "key"}, fullResult());
    EXPECT_EQ(textOf(folder / "a.h5"), textOf(folder / "b.h5"));
}

TEST(ResultFile, AnyChangedByteOfTheContentIsFound)
{
    const TemporaryFolder folder;
    DataArray array = columnOf("values", "", std::vector<double>(64, 1.25));
    Result result;
    result.arrays = {array};
    writeResultFile(folder / "r.h5", {"stage", "key"}, result);
    std::string bytes = textOf(folder / "r.h5");
    const std::string one("\0\0\0\0\0\0\xF4\x3F", 8); // 1.25, little-endian
    const auto at = bytes.find(one + one);
    ASSERT_NE(at, std::string::npos);
    bytes[at + 9] = '\x01';
    folder.write("r.h5", bytes);
    EXPECT_EQ(codeOfReading(folder / "r.h5"), ErrorCode::ResultDamaged);
}

TEST(ResultFile, TruncatedAndForeignFilesAreDamaged)
{
    const TemporaryFolder folder;
    writeResultFile(folder / "r.h5", {"stage", "key"}, fullResult());
    const std::string bytes = textOf(folder / "r.h5");
    for (std::size_t size = 1; size < bytes.size(); size += 97) {
        folder.write("cut.h5", bytes.substr(0, size));
        EXPECT_EQ(codeOfReading(folder / "cut.h5"), ErrorCode::ResultDamaged) << size << " bytes";
    }
    folder.write("text.h5", "this is no HDF5 file");
    EXPECT_EQ(codeOfReading(folder / "text.h5"), ErrorCode::ResultDamaged);
}

TEST(ResultStore, TellsFreshFromOtherFromDamagedFromMissing)
{
    const TemporaryFolder folder;
    const ResultStore store(folder.path());
    EXPECT_EQ(store.load("sequences/a/statistics", "k").state, ResultStore::State::Missing);
    store.save("sequences/a/statistics", "k", fullResult());
    EXPECT_EQ(store.load("sequences/a/statistics", "k").state, ResultStore::State::Fresh);
    EXPECT_EQ(*store.load("sequences/a/statistics", "k").result, fullResult());
    EXPECT_EQ(store.load("sequences/a/statistics", "l").state, ResultStore::State::OtherKey);
    std::ofstream(store.fileOf("sequences/a/statistics"), std::ios::binary).close();
    EXPECT_EQ(store.load("sequences/a/statistics", "k").state, ResultStore::State::Damaged);
}

namespace {

/// A project in a folder of its own, and a folder of stand-ins that is not the user's.
class ResultPlacesOf : public ::testing::Test
{
protected:
    ResultPlacesOf() { setResultRoot(folder / "cache"); }
    ~ResultPlacesOf() override { setResultRoot({}); }
    /// Nothing can be written beside the project: a file stands where its folder of results should be.
    void block() const { folder.write("p.quadrille.cache", "in the way"); }
    ResultStore store() const { return ResultStore(cacheFolder(project)); }

    TemporaryFolder folder;
    std::filesystem::path project = folder / "p.quadrille";
};

} // namespace

TEST_F(ResultPlacesOf, AProjectAreBesideItOrWhereItWasChosen)
{
    EXPECT_EQ(cacheFolder(project), folder / "p.quadrille.cache");
    EXPECT_FALSE(resultPlaces(project).isElsewhere);
    chooseResultFolder(project, folder / "chosen");
    EXPECT_EQ(cacheFolder(project), folder / "chosen");
    EXPECT_FALSE(resultPlaces(project).isElsewhere);
    chooseResultFolder(project, {});
    EXPECT_EQ(cacheFolder(project), folder / "p.quadrille.cache");
}

TEST_F(ResultPlacesOf, AProjectThatCannotBeWrittenAreAmongTheUsers)
{
    block();
    const ResultPlaces places = resultPlaces(project);
    EXPECT_TRUE(places.isElsewhere);
    EXPECT_EQ(places.written.parent_path(), folder / "cache");
    EXPECT_NE(places.written, resultPlaces(folder / "q/p.quadrille").written);
    prepareResults(project, 1000);
    EXPECT_TRUE(store().save("a/b", "k", fullResult()));
    EXPECT_EQ(store().load("a/b", "k").state, ResultStore::State::Fresh);
    std::filesystem::remove(folder / "p.quadrille.cache");
    recheckResultPlaces(project);
    EXPECT_FALSE(resultPlaces(project).isElsewhere);
    EXPECT_FALSE(std::filesystem::exists(folder / "p.quadrille.cache"));
    EXPECT_EQ(store().load("a/b", "k").state, ResultStore::State::Fresh); // read from where it is
}

TEST_F(ResultPlacesOf, AProjectThatCannotBeWrittenCountWhenTheyAreBesideIt)
{
    EXPECT_TRUE(store().save("a/b", "shared", fullResult()));
    chooseResultFolder(project, folder / "own");
    EXPECT_EQ(store().load("a/b", "shared").state, ResultStore::State::Fresh);
    EXPECT_TRUE(store().save("a/b", "mine", Result()));
    EXPECT_EQ(*store().load("a/b", "shared").result, fullResult());
    EXPECT_EQ(*store().load("a/b", {}).result, Result()); // the newest
    store().prefer("a/b", "shared");
    EXPECT_EQ(*store().load("a/b", {}).result, fullResult());
    chooseResultFolder(project, {});
}

TEST_F(ResultPlacesOf, AProjectAreTriedBeforeAnythingIsComputed)
{
    block();
    prepareResults(project, 0);
    EXPECT_EQ(cacheFolder(project).parent_path(), folder / "cache");
    folder.write("nowhere", "in the way, too");
    setResultRoot(folder / "nowhere");
    EXPECT_THROW(prepareResults(project, 0), Error);
    setResultRoot(folder / "cache");
    std::filesystem::remove(folder / "p.quadrille.cache");
    prepareResults(project, 0);
    EXPECT_EQ(cacheFolder(project), folder / "p.quadrille.cache");
    try {
        prepareResults(project, std::uint64_t{1} << 60U);
        FAIL() << "an exabyte was free";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("are free on this disk"), std::string::npos);
    }
    prepareResults(project, 0);
}

TEST_F(ResultPlacesOf, AProjectThatLoseTheirFolderAreStoredAnew)
{
    const ResultStore kept = store();
    EXPECT_TRUE(kept.save("a/b", "k", fullResult()));
    std::filesystem::remove_all(cacheFolder(project));
    EXPECT_TRUE(kept.save("a/c", "k", fullResult()));
    std::filesystem::remove_all(folder / "p.quadrille.cache");
    block();
    EXPECT_TRUE(kept.save("a/d", "k", fullResult()));
    EXPECT_EQ(kept.load("a/d", "k").state, ResultStore::State::Fresh);
    std::filesystem::remove_all(folder / "p.quadrille.cache");
    prepareResults(project, 0);
}

TEST_F(ResultPlacesOf, AProjectThatCannotBeStoredAnywhereStayInMemoryUntilTheyCan)
{
    block();
    setResultRoot(folder.write("nowhere", "in the way, too"));
    EXPECT_FALSE(store().save("a/b", "k", fullResult()));
    EXPECT_EQ(unstoredResults(), std::vector<std::string>{"a/b"});
    EXPECT_EQ(*store().load("a/b", "k").result, fullResult());
    EXPECT_EQ(storeUnstoredResults(), 1U);
    std::filesystem::remove(folder / "p.quadrille.cache");
    EXPECT_EQ(storeUnstoredResults(), 0U);
    EXPECT_EQ(readResultFile(folder / "p.quadrille.cache/a/b.h5"), fullResult());
    setResultRoot(folder / "cache");
    prepareResults(project, 0);
}

TEST_F(ResultPlacesOf, AProjectAreGivenToItsCopyWhole)
{
    for (const char* step : {"graph/edges", "animations/a/clip", "contact-sheet"})
        EXPECT_TRUE(store().save(step, "k", fullResult()));
    folder.write("p.quadrille.cache/media.json", "{}");
    Result withFiles = fullResult();
    withFiles.files = {{"p.quadrille.cache/appearance/a/files/flows/f.warp", "h"}, {"out/x.obj", "h"}};
    EXPECT_TRUE(store().save("appearance/a/model", "k", withFiles));
    folder.write("p.quadrille.cache/appearance/a/files/flows/f.warp", "warp");
    const auto names = [](const std::filesystem::path& place) {
        std::set<std::string> found;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(place))
            found.insert(entry.path().lexically_relative(place).string());
        return found;
    };
    const std::set<std::string> given{"graph",
                                      "graph/edges.h5",
                                      "animations",
                                      "animations/a",
                                      "animations/a/clip.h5",
                                      "appearance",
                                      "appearance/a",
                                      "appearance/a/model.h5",
                                      "appearance/a/files",
                                      "appearance/a/files/flows",
                                      "appearance/a/files/flows/f.warp"};
    ASSERT_TRUE(linkResults(project, folder / "linked/q.quadrille"));
    EXPECT_EQ(names(folder / "linked/q.quadrille.cache"), given);
    copyResults(project, folder / "copied/q.quadrille");
    EXPECT_EQ(names(folder / "copied/q.quadrille.cache"), given);
    // Results name their own files where these are now, and others as before.
    for (const char* copy : {"linked", "copied"}) {
        const auto model = ResultStore(folder / copy / "q.quadrille.cache").load("appearance/a/model", "k");
        ASSERT_EQ(model.state, ResultStore::State::Fresh) << copy;
        EXPECT_EQ(model.result->files[0].path, "q.quadrille.cache/appearance/a/files/flows/f.warp");
        EXPECT_EQ(model.result->files[1], withFiles.files[1]);
        EXPECT_EQ(model.result->arrays, withFiles.arrays);
    }
    EXPECT_EQ(*store().load("appearance/a/model", "k").result, withFiles);
    // Writing one anew leaves the other as it is.
    EXPECT_TRUE(store().save("graph/edges", "l", Result()));
    for (const char* copy : {"linked/q.quadrille", "copied/q.quadrille"})
        EXPECT_EQ(*ResultStore(cacheFolder(folder / copy)).load("graph/edges", "k").result, fullResult());
    // Cancelled, nothing of it is there.
    CancelToken token;
    const Progress cancelled(token, [&token](double) { token.cancel(); });
    EXPECT_THROW(copyResults(project, folder / "half/q.quadrille", cancelled), Error);
    EXPECT_TRUE(!std::filesystem::exists(folder / "half") || names(folder / "half").empty());
    // What the copy has of its own stays.
    EXPECT_TRUE(ResultStore(folder / "linked/q.quadrille.cache").save("own", "k", Result()));
    copyResults(project, folder / "linked/q.quadrille");
    EXPECT_EQ(names(folder / "linked/q.quadrille.cache").count("own.h5"), 1U);
}

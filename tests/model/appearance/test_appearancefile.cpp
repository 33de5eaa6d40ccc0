// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "appearancefixture.h"
#include "model/appearance/appearancefile.h"
#include "model/appearance/fileseal.h"
#include "model/core/hdf5.h"
#include "model/core/random.h"
#include "tests/model/codeof.h"
#include "tests/model/core/temporaryfolder.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

namespace quadrille {

using namespace test;

namespace {

AppearanceModel modelToStore()
{
    return quantised(randomSpaces(texelsOfDiscs(32, 24, {{10, 10, 8}, {25, 12, 5}}), {.components = 3}, 21));
}

std::string bytesOfFile(const std::filesystem::path& path)
{
    return std::string(readFile(path).text());
}

TEST(AppearanceFile, HoldsAModelAsItWasWritten)
{
    const TemporaryFolder folder;
    const AppearanceModel model = modelToStore();
    writeAppearanceFile(folder / "new" / "a.h5", model);
    const AppearanceModel read = readAppearanceFile(folder / "new" / "a.h5");
    EXPECT_EQ(read, model);
    writeAppearanceFile(folder / "b.h5", read);
    EXPECT_EQ(bytesOfFile(folder / "new" / "a.h5"), bytesOfFile(folder / "b.h5"));
}

TEST(AppearanceFile, HoldsModelsWithoutComponentsFramesOrWarps)
{
    const TemporaryFolder folder;
    AppearanceModel model = modelToStore();
    model.frames.clear();
    model.textures.coefficients.clear();
    model.warps = {};
    model.grid = {};
    writeAppearanceFile(folder / "a.h5", model);
    EXPECT_EQ(readAppearanceFile(folder / "a.h5"), model);
    model.textures = quantised(LinearSpace{.mean = std::vector<float>(3 * model.texels.texels.size(), 9)});
    writeAppearanceFile(folder / "a.h5", model);
    EXPECT_EQ(readAppearanceFile(folder / "a.h5"), model);
    writeAppearanceFile(folder / "a.h5", {});
    EXPECT_EQ(readAppearanceFile(folder / "a.h5"), AppearanceModel{});
}

TEST(AppearanceFile, SaysWhatIsWrongWithOtherFiles)
{
    const TemporaryFolder folder;
    EXPECT_EQ(codeOf([&] { readAppearanceFile(folder / "none.h5"); }), ErrorCode::FileNotFound);
    EXPECT_EQ(codeOf([&] { readAppearanceFile(folder.write("empty.h5", "")); }), ErrorCode::FileEmpty);
    const auto text = folder.write("text.h5", "nothing of the kind");
    EXPECT_EQ(codeOf([&] { readAppearanceFile(text); }), ErrorCode::FileSyntax);
    const auto foreign = folder / "foreign.h5";
    {
        const auto lock = lockHdf5();
        Hdf5Handle(H5Fcreate(foreign.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    }
    try {
        readAppearanceFile(foreign);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what())
                      .find(foreign.string() + ": This is not what the format allows here: it "
                                               "is no model of appearance. Export"),
                  0U)
            << error.what();
    }
}

TEST(AppearanceFile, IsRefusedWhereItsPartsDoNotFit)
{
    const TemporaryFolder folder;
    const auto path = folder / "a.h5";
    const auto isRefused = [&](const auto& change) {
        AppearanceModel model = modelToStore();
        change(model);
        writeAppearanceFile(path, model);
        return codeOf([&] { readAppearanceFile(path); }) == ErrorCode::FileSyntax;
    };
    EXPECT_TRUE(isRefused([](AppearanceModel& model) { model.texels.texels.back() = 32 * 24; }));
    EXPECT_TRUE(isRefused([](AppearanceModel& model) { model.texels.texels[1] = model.texels.texels[0]; }));
    EXPECT_TRUE(isRefused([](AppearanceModel& model) { model.texels.texels.pop_back(); }));
    EXPECT_TRUE(isRefused([](AppearanceModel& model) { model.texels.charts[3] = 2; }));
    EXPECT_TRUE(isRefused([](AppearanceModel& model) { model.texels.covered.pop_back(); }));
    EXPECT_TRUE(isRefused([](AppearanceModel& model) { model.texels.width = 1 << 20; }));
    EXPECT_TRUE(isRefused([](AppearanceModel& model) { model.grid.height = 100; }));
    EXPECT_TRUE(isRefused([](AppearanceModel& model) { model.grid.spacing = 0; }));
    EXPECT_TRUE(isRefused([](AppearanceModel& model) { model.textures.meanStep = NAN; }));
    EXPECT_TRUE(isRefused([](AppearanceModel& model) { model.textures.scales[1] = INFINITY; }));
    EXPECT_TRUE(isRefused([](AppearanceModel& model) { model.warps.coefficients[0] = NAN; }));
}

/// Reads a file of these bytes. \return the error.
ErrorCode codeOfDamaged(const std::filesystem::path& path, const std::string& bytes)
{
    std::filesystem::remove(path); // writing over a file waits for the disk
    std::ofstream(path, std::ios::binary) << bytes;
    try {
        readAppearanceFile(path);
        return ErrorCode::Unexpected;
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
        return error.code();
    }
}

TEST(AppearanceFile, IsRefusedWhereItIsDamagedAnywhere)
{
    const TemporaryFolder folder;
    writeAppearanceFile(folder / "a.h5", modelToStore());
    const std::string bytes = bytesOfFile(folder / "a.h5");
    Random random(5);
    for (int i = 0; i < 600; ++i) {
        std::string damaged = bytes;
        // In the seal, in the library's own structures, and anywhere.
        const double range = i % 3 == 0 ? 512 : i % 3 == 1 ? 4096 : static_cast<double>(bytes.size());
        const auto at = static_cast<std::size_t>(random.unit() * range);
        damaged[at] = static_cast<char>(damaged[at] ^ static_cast<char>(1U << (random.next() % 8)));
        const ErrorCode code = codeOfDamaged(folder / "b.h5", damaged);
        EXPECT_TRUE(code == ErrorCode::FileSyntax || (at < 512 && code == ErrorCode::FileTruncated)) << at;
    }
    EXPECT_EQ(codeOfDamaged(folder / "b.h5", bytes + '\0'), ErrorCode::FileSyntax);
}

TEST(AppearanceFile, IsRefusedWhereItIsCutAnywhere)
{
    const TemporaryFolder folder;
    writeAppearanceFile(folder / "a.h5", modelToStore());
    const std::string bytes = bytesOfFile(folder / "a.h5");
    for (std::size_t size = 1; size < bytes.size(); size += 1 + size / 20) {
        const ErrorCode code = codeOfDamaged(folder / "b.h5", bytes.substr(0, size));
        EXPECT_EQ(code, size < 24 ? ErrorCode::FileSyntax : ErrorCode::FileTruncated) << size;
    }
    EXPECT_EQ(codeOfDamaged(folder / "b.h5", bytes.substr(0, bytes.size() - 1)), ErrorCode::FileTruncated);
}

/// Whole as it is sealed, but with something else in it.
TEST(AppearanceFile, IsRefusedWhereDatasetsAreOthers)
{
    const TemporaryFolder folder;
    const auto path = folder / "a.h5";
    const auto codeAfter = [&](const auto& change) {
        writeAppearanceFile(path, modelToStore());
        {
            const auto lock = lockHdf5();
            const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
            change(file.id());
        }
        sealFile(path);
        return codeOf([&] { readAppearanceFile(path); });
    };
    const auto replaceBy = [](hid_t file, const char* name, hid_t type, hsize_t count) {
        H5Ldelete(file, name, H5P_DEFAULT);
        const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
        const Hdf5Handle dataset(
            H5Dcreate2(file, name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    };
    for (const char* name :
         {"atlas", "texels", "frame-sequences", "mean-step", "components", "warps", "grid"}) {
        EXPECT_EQ(codeAfter([&](hid_t file) { H5Ldelete(file, name, H5P_DEFAULT); }), ErrorCode::FileSyntax)
            << name;
        EXPECT_EQ(codeAfter([&](hid_t file) { replaceBy(file, name, H5T_IEEE_F64BE, 3); }),
                  ErrorCode::FileSyntax)
            << name;
    }
    EXPECT_EQ(codeAfter([&](hid_t file) { replaceBy(file, "components", H5T_STD_I8LE, hsize_t{1} << 50); }),
              ErrorCode::FileSyntax);
    EXPECT_EQ(codeAfter([&](hid_t file) { replaceBy(file, "grid", H5T_STD_I64LE, 2); }),
              ErrorCode::FileSyntax);
}

TEST(AppearanceFile, IsNotPutOverAnInput)
{
    const TemporaryFolder folder;
    const auto path = folder.write("a.h5", "somebody's");
    WriteGuard guard;
    EXPECT_EQ(codeOf([&] { writeAppearanceFile(path, modelToStore(), &guard); }), ErrorCode::BadArgument);
    EXPECT_EQ(bytesOfFile(path), "somebody's");
}

} // namespace

} // namespace quadrille

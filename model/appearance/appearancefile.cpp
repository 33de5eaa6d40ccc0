// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/appearancefile.h"

#include "model/appearance/fileseal.h"
#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/hdf5values.h"
#include "model/core/message.h"
#include "model/core/stagedfiles.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

constexpr const char* appearanceFormat = "quadrille-appearance";
constexpr std::int64_t longestSide = 65'535; ///< of an atlas or a grid

/// What is no array in the model is one in its file.
struct FileParts
{
    std::vector<std::int64_t> atlas;
    std::vector<std::int64_t> grid;
    std::vector<float> meanStep;
    std::vector<float> warpMeanStep;
    std::vector<std::string> sequences;
    std::vector<std::int64_t> frames;
};

/// What is said of a dataset.
struct DatasetNote
{
    const char* name;
    const char* unit;
    const char* description;
};

struct SpaceNotes
{
    DatasetNote mean;
    DatasetNote meanStep;
    DatasetNote components;
    DatasetNote scales;
    DatasetNote eigenvalues;
    DatasetNote coefficients;
};

constexpr SpaceNotes textureNotes{
    {"mean", "mean-step",
     "Red, green and blue of each used texel of the mean texture; filled up to whole blocks."},
    {"mean-step", "grey level", "What one step of the mean is worth."},
    {"components", "component-scale",
     "Eigen textures: blocks × components × values, red, green and blue of each used texel in turn."},
    {"component-scales", "grey level",
     "Blocks × components: what one step of an Eigen texture is worth there."},
    {"eigenvalues", "grey level²",
     "Variances of the textures along their components, also of those left out."},
    {"coefficients", "", "Frames × components: what the textures were made from."}};
constexpr SpaceNotes warpNotes{
    {"warp-mean", "warp-mean-step",
     "Right and down of each node of the mean warp; filled up to whole blocks."},
    {"warp-mean-step", "texel", "What one step of the mean warp is worth."},
    {"warps", "warp-scale",
     "Eigen warps: blocks × components × values, right and down of each node in turn."},
    {"warp-scales", "texel", "Blocks × components: what one step of an Eigen warp is worth there."},
    {"warp-eigenvalues", "texel²", "Variances of the warps along their components, also of those left out."},
    {"warp-coefficients", "", "Frames × components: what the warps were made from."}};

/// Shows a visitor each dataset of a space, and its shape as the space has it.
template <typename Visitor, typename Space, typename Steps>
void visitSpace(Visitor& visitor, const SpaceNotes& notes, Space& space, Steps& meanStep, std::int64_t frames)
{
    visitor.array(notes.mean, space.mean, {static_cast<std::int64_t>(space.mean.size())});
    visitor.array(notes.meanStep, meanStep, {1});
    visitor.array(notes.components, space.steps, {space.blocks(), space.count, QuantisedSpace::blockSize});
    visitor.array(notes.scales, space.scales, {space.blocks(), space.count});
    visitor.array(notes.eigenvalues, space.eigenvalues,
                  {static_cast<std::int64_t>(space.eigenvalues.size())});
    visitor.array(notes.coefficients, space.coefficients, {frames, space.count});
}

template <typename Visitor, typename Model, typename Parts>
void visitFile(Visitor& visitor, Model& model, Parts& parts)
{
    auto& texels = model.texels;
    const auto frames = static_cast<std::int64_t>(parts.frames.size());
    visitor.array({"atlas", "", "Width and height in texels, number of charts."}, parts.atlas, {3});
    visitor.array({"texels", "", "Used texels: row · width + column, rows from top to bottom."},
                  texels.texels, {static_cast<std::int64_t>(texels.texels.size())});
    visitor.array({"charts", "", "Of each used texel, the chart of the UV layout."}, texels.charts,
                  {static_cast<std::int64_t>(texels.charts.size())});
    visitor.array({"covered", "", "Of each used texel, 1 where a triangle covers it, 0 in the gutter."},
                  texels.covered, {static_cast<std::int64_t>(texels.covered.size())});
    visitor.texts({"frame-sequences", "", "The sequences of the frames that the model was made from."},
                  parts.sequences);
    visitor.array({"frames", "frames", "Their frames, from zero on."}, parts.frames, {frames});
    visitSpace(visitor, textureNotes, model.textures, parts.meanStep, frames);
    visitor.array({"grid", "", "Of the warps: texels from node to node, nodes across, nodes down."},
                  parts.grid, {3});
    visitSpace(visitor, warpNotes, model.warps, parts.warpMeanStep, frames);
}

class AppearanceWriter
{
public:
    explicit AppearanceWriter(hid_t file) : m_file(file) {}

    template <typename Values>
    void array(const DatasetNote& note, const Values& values, const std::vector<std::int64_t>& shape)
    {
        const auto [inFile, inMemory] = hdf5data::typesOf<typename Values::value_type>();
        write(note, shape, inFile, inMemory, values.empty() ? nullptr : values.data());
    }
    void texts(const DatasetNote& note, const std::vector<std::string>& values)
    {
        std::size_t size = 1;
        for (const std::string& value : values)
            size = std::max(size, value.size());
        const Hdf5Handle type = hdf5data::textType(size);
        const std::vector<char> packed = hdf5data::packTexts(values, size);
        write(note, {static_cast<std::int64_t>(values.size())}, type.id(), type.id(),
              values.empty() ? nullptr : packed.data());
    }

private:
    void write(const DatasetNote& note, const std::vector<std::int64_t>& shape, hid_t inFile, hid_t inMemory,
               const void* values)
    {
        const Hdf5Handle dataset = hdf5data::createDataset(m_file, note.name, shape, inFile);
        if (values)
            hdf5data::check(H5Dwrite(dataset.id(), inMemory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
        hdf5data::writeText(dataset.id(), "description", note.description);
        hdf5data::writeText(dataset.id(), "unit", note.unit);
    }

    hid_t m_file;
};

/// Reads what a file holds, whatever the model says of its shape; `count` of a space is found by its
/// components.
class AppearanceReader
{
public:
    /// \param limit  bytes that the values of a dataset may take; more is damage.
    AppearanceReader(hid_t file, std::uint64_t limit) : m_file(file), m_limit(limit) {}

    template <typename Values>
    void array(const DatasetNote& note, Values& values, const std::vector<std::int64_t>& /*shape*/)
    {
        const auto [inFile, inMemory] = hdf5data::typesOf<typename Values::value_type>();
        open(note);
        const Hdf5Handle type = hdf5data::handle(H5Dget_type(m_dataset.id()), H5Tclose);
        if (hdf5data::check(H5Tequal(type.id(), inFile)) == 0)
            throw hdf5data::Failure{};
        values.resize(countOf(sizeof(typename Values::value_type)));
        if (!values.empty())
            hdf5data::check(H5Dread(m_dataset.id(), inMemory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    }
    void texts(const DatasetNote& note, std::vector<std::string>& values)
    {
        open(note);
        const Hdf5Handle type = hdf5data::handle(H5Dget_type(m_dataset.id()), H5Tclose);
        const std::size_t size = H5Tget_size(type.id());
        if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0 || size == 0)
            throw hdf5data::Failure{};
        std::vector<char> packed(size * countOf(size));
        if (!packed.empty())
            hdf5data::check(H5Dread(m_dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()));
        values = hdf5data::unpackTexts<std::vector<std::string>>(packed, size);
    }

private:
    void open(const DatasetNote& note)
    {
        m_dataset = hdf5data::handle(H5Dopen2(m_file, note.name, H5P_DEFAULT), H5Dclose);
    }
    std::size_t countOf(std::size_t bytes) const
    {
        const Hdf5Handle space = hdf5data::handle(H5Dget_space(m_dataset.id()), H5Sclose);
        const auto count =
            static_cast<std::uint64_t>(hdf5data::check(H5Sget_simple_extent_npoints(space.id())));
        if (count > m_limit / bytes || !holdsAllValues(m_dataset))
            throw hdf5data::Failure{};
        return count;
    }

    hid_t m_file;
    std::uint64_t m_limit;
    Hdf5Handle m_dataset;
};

void require(bool holds)
{
    if (!holds)
        throw hdf5data::Failure{};
}

template <typename Values>
bool areFinite(const Values& values)
{
    return std::ranges::all_of(values, [](auto value) { return std::isfinite(value); });
}

/// Gives a space its sizes.
/// \throws Failure where its arrays do not fit them.
void finishSpace(QuantisedSpace& space, std::int64_t size, const std::vector<float>& meanStep,
                 std::size_t frames)
{
    require(meanStep.size() == 1);
    space.size = size;
    space.meanStep = meanStep.front();
    const auto blocks = static_cast<std::size_t>(space.blocks());
    require(blocks == 0 || space.scales.size() % blocks == 0);
    const std::size_t count = blocks == 0 ? 0 : space.scales.size() / blocks;
    space.count = static_cast<std::int64_t>(count);
    require(space.mean.size() == blocks * QuantisedSpace::blockSize);
    require(space.scales.size() == blocks * count);
    require(space.steps.size() == space.mean.size() * count);
    require(space.coefficients.size() == frames * count);
    require(areFinite(meanStep) && areFinite(space.scales) && areFinite(space.eigenvalues) &&
            areFinite(space.coefficients));
}

/// Gives them their sizes.
/// \throws Failure where they do not lie in them.
void finishTexels(UsedTexels& used, const std::vector<std::int64_t>& atlas)
{
    require(atlas.size() == 3);
    for (const std::int64_t value : atlas)
        require(value >= 0 && value <= longestSide);
    used.width = static_cast<int>(atlas[0]);
    used.height = static_cast<int>(atlas[1]);
    used.chartCount = static_cast<int>(atlas[2]);
    require(used.charts.size() == used.texels.size() && used.covered.size() == used.texels.size());
    require(std::ranges::adjacent_find(used.texels, std::greater_equal<>()) == used.texels.end());
    require(used.texels.empty() || std::int64_t{used.texels.back()} < atlas[0] * atlas[1]);
    require(std::ranges::all_of(used.charts, [&](std::uint16_t chart) { return chart < used.chartCount; }));
}

/// Gives a model what is no array in it.
/// \throws Failure where its parts do not fit each other.
void finish(AppearanceModel& model, const FileParts& parts)
{
    finishTexels(model.texels, parts.atlas);
    require(parts.grid.size() == 3);
    for (const std::int64_t value : parts.grid)
        require(value >= 0 && value <= longestSide);
    model.grid = {static_cast<int>(parts.grid[0]), static_cast<int>(parts.grid[1]),
                  static_cast<int>(parts.grid[2])};
    require(model.grid.spacing > 0);
    require(parts.sequences.size() == parts.frames.size());
    const std::size_t frames = parts.frames.size();
    for (std::size_t f = 0; f < frames; ++f)
        model.frames.push_back({parts.sequences[f], FrameIndex(parts.frames[f])});
    finishSpace(model.textures, 3 * static_cast<std::int64_t>(model.texels.texels.size()), parts.meanStep,
                frames);
    finishSpace(model.warps, 2 * model.grid.nodes(), parts.warpMeanStep, frames);
}

FileParts partsOf(const AppearanceModel& model)
{
    FileParts parts{.atlas = {model.texels.width, model.texels.height, model.texels.chartCount},
                    .grid = {model.grid.spacing, model.grid.width, model.grid.height},
                    .meanStep = {model.textures.meanStep},
                    .warpMeanStep = {model.warps.meanStep}};
    for (const AppearanceFrame& frame : model.frames) {
        parts.sequences.push_back(frame.sequence);
        parts.frames.push_back(frame.frame.value);
    }
    return parts;
}

} // namespace

void writeAppearanceFile(const fs::path& path, const AppearanceModel& model, WriteGuard* guard)
{
    const FileParts parts = partsOf(model);
    const auto write = [&](const fs::path& temporary) {
        const auto lock = lockHdf5();
        try {
            const Hdf5Handle file = hdf5data::createFile(temporary, sealSize);
            hdf5data::writeText(file.id(), "format", appearanceFormat);
            AppearanceWriter writer(file.id());
            visitFile(writer, model, parts);
            hdf5data::check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL));
        } catch (const hdf5data::Failure& failure) {
            hdf5data::throwWriting(path, failure);
        }
        sealFile(temporary);
    };
    writeGuarded(path, write, guard);
}

AppearanceModel readAppearanceFile(const fs::path& path)
{
    checkSeal(path);
    const std::uint64_t size = InputFile(path).size();
    const auto lock = lockHdf5();
    const Hdf5Handle file = openHdf5(path);
    try {
        AppearanceModel model;
        FileParts parts;
        AppearanceReader reader(file.id(), size);
        visitFile(reader, model, parts);
        finish(model, parts);
        return model;
    } catch (const hdf5data::Failure&) {
        throw Error(ErrorCode::FileSyntax,
                    {path, {}, {{"reason", QUADRILLE_MESSAGE("a part of the file is damaged")}}});
    }
}

} // namespace quadrille

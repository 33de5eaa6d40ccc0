// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/appearancefile.h"
#include "model/appearance/completion.h"
#include "model/appearance/texturequality.h"
#include "model/core/error.h"
#include "model/core/message.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/fields/writefields.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/appearanceposes.h"
#include "model/project/steps/buildstep.h"
#include "model/project/steps/completionmask.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>

namespace quadrille {

namespace {

std::vector<std::filesystem::path> filesOf(SequenceOpener& opener, const std::vector<std::string>& sequences,
                                           const Progress& progress)
{
    std::vector<std::filesystem::path> files;
    for (const std::string& name : sequences) {
        const auto own = opener.filesOf(name, progress);
        files.insert(files.end(), own.begin(), own.end());
    }
    return files;
}

/// By name: they are told apart by it in results.
std::string settingsOf(const Project& project, const std::vector<std::string>& sequences)
{
    std::string text;
    for (const std::string& name : sequences) {
        if (const SequenceEntry* sequence = findSequence(project, name))
            text += "\n" + name + "\n" + sequenceSettings(project, *sequence);
    }
    return text;
}

DataArray columnOfValues(const char* name, const char* unit, const char* description,
                         std::vector<double> values)
{
    DataArray array = columnOf(name, unit, std::move(values));
    array.description = description;
    return array;
}

DataArray coefficientsArray(const char* name, const char* description, const QuantisedSpace& space)
{
    return {.name = name,
            .description = description,
            .shape = {space.samples(), space.count},
            .values = space.coefficients};
}

/// How well each texture is met.
DataTable metricsTable(const AppearanceModel& model, const BuiltAppearance& built,
                       const TextureSource& source, const Progress& progress)
{
    const AppearanceDecoder decoder(std::make_shared<const AppearanceModel>(model));
    std::vector<double> qualities(2 * model.frames.size());
    localExecutor().run(makeTasks<double>(
                            source.count,
                            [&](std::int64_t row, const Progress&) {
                                const Image made =
                                    decoder.decode(coefficientsOf(model, static_cast<std::size_t>(row)));
                                const PictureQuality quality =
                                    textureQuality(*source.read(row), made, model.texels);
                                return std::vector<double>{quality.similarity, quality.meanSquaredError};
                            },
                            [&](std::int64_t row, std::span<const double> values) {
                                std::copy(values.begin(), values.end(), qualities.begin() + 2 * row);
                            }),
                        progress);
    TableBuilder table("metrics", "How well the model meets each texture, over the texels that are used, and "
                                  "how far the texture was aligned.");
    table.whole("row").text("sequence").whole("frame", "frame").real("similarity");
    table.real("mean-squared-error", "grey level²").real("displacement", "texel");
    table.real("difference-before", "grey level").real("difference-after", "grey level");
    for (std::size_t row = 0; row < model.frames.size(); ++row) {
        const AlignmentFigures& figures = built.figures[row];
        table.add({static_cast<std::int64_t>(row), model.frames[row].sequence, model.frames[row].frame.value,
                   qualities[2 * row], qualities[2 * row + 1], figures.displacement, figures.before,
                   figures.after});
    }
    return std::move(table).table();
}

Result buildModel(const AppearanceWork& work, const Progress& progress)
{
    const AppearanceTraining training = appearanceTraining(*work.opener, work.entry, progress.part(0, 0.02));
    const TextureSource source = training.source();
    BuildAppearanceOptions options = work.options();
    options.alignment.reference = training.reference;
    std::filesystem::create_directories(work.folder());
    FlowFiles flows = work.flows(training, progress.part(0.02, 0.04));
    const BuiltAppearance built =
        buildAppearance(source, *training.topology, options, &flows, progress.part(0.04, 0.9));
    const AppearanceModel model = quantised(built.used, built.grid, built.textures, built.warps,
                                            training.frames(), progress.part(0.9, 0.92));
    const std::filesystem::path file = work.folder() / "model.h5";
    writeAppearanceFile(file, model);
    if (built.warps.count() > 0) // else none was asked for, and the warps of before may be wanted again
        flows.removeOthers();
    Result result;
    result.arrays = {
        columnOfValues("eigenvalues", "grey level²",
                       "Variances along Eigen textures, also of those left out.", model.textures.eigenvalues),
        columnOfValues("warp-eigenvalues", "texel²", "Variances along Eigen warps, also of those left out.",
                       model.warps.eigenvalues),
        coefficientsArray("coefficients", "Textures × components: where they lie among Eigen textures.",
                          model.textures),
        coefficientsArray("warp-coefficients", "Textures × components: where they lie among Eigen warps.",
                          model.warps),
        columnOf("reference", "row", std::vector{built.reference})};
    result.arrays.back().description = "The texture that all others are aligned to.";
    result.tables = {rowsTable(training.rows), metricsTable(model, built, source, progress.part(0.92, 1))};
    result.files = {work.written(file, progress)};
    return result;
}

BuildStep modelStep(const std::shared_ptr<const AppearanceWork>& work)
{
    const Project& project = work->opener->project();
    BuildStep step = work->step(appearanceModelStep(work->entry.name));
    const std::vector<std::string> sequences = trainingSequences(project, work->entry);
    AppearanceEntry learned = work->entry;
    learned.name.clear();
    learned.varied = {};
    for (CompletionEntry& completion : learned.completions) { // all that counts is which textures they are
        completion.mask.clear();
        completion.strokes.clear();
    }
    step.version = 6;
    step.settings = settingsText(learned) + settingsOf(project, sequences);
    step.inputs = clipInputs(project, sequences);
    step.files = [work, sequences](const Progress& progress) {
        return filesOf(*work->opener, sequences, progress);
    };
    step.compute = [work](const StepContext&, const Progress& progress) {
        return buildModel(*work, progress);
    };
    return step;
}

/// Fills in what is masked of one texture.
CompletedFrame complete(const AppearanceWork& work, const AppearanceDecoder& decoder,
                        const ChartLookup& charts, const CompletionEntry& completion,
                        const Progress& progress)
{
    const auto opened = work.opener->open(completion.frame.sequence);
    if (completion.frame.frame.value >= opened->sequence.frameCount())
        throwNoFrame(completion.frame.sequence, completion.frame.frame.value, opened->sequence.frameCount());
    const TextureSet& textures = opened->sequence.textures;
    const int index = textures.indexFor(opened->sequence.sourceFrame(completion.frame.frame));
    if (index < 0)
        throwInvalid("“" + completion.frame.sequence + "” has no texture in frame " +
                         std::to_string(completion.frame.frame.value),
                     QUADRILLE_MESSAGE("Give it one, or take it out of the completions."));
    const auto texture = textures.image(index);
    const auto known =
        knownTexels(completion, *texture, decoder.model().texels,
                    textures.textures()[static_cast<std::size_t>(index)].file, work.opener->folder());
    CompletionOptions options;
    options.estimate = [&](const Image& fixed, const Image& moving, std::span<const std::uint8_t>) {
        return charts.atNodes(denseFlow(fixed, moving, charts, {}, progress.part(0, 0.3)),
                              decoder.model().grid);
    };
    CompletedTexture completed = completeTexture(decoder, *texture, known, options, progress.part(0.3, 1));
    const std::filesystem::path file =
        work.folder() /
        (completion.frame.sequence + "_" + std::to_string(completion.frame.frame.value) + ".png");
    writeImage(completed.texture, file);
    return {completion.frame.sequence, completion.frame.frame, file, std::move(completed.coefficients)};
}

BuildStep completionsStep(const std::shared_ptr<const AppearanceWork>& work)
{
    const Project& project = work->opener->project();
    BuildStep step = work->step(appearanceCompletionsStep(work->entry.name));
    AppearanceEntry masked;
    masked.completions = work->entry.completions;
    std::vector<std::string> sequences;
    for (const CompletionEntry& completion : masked.completions) {
        const std::string& name = completion.frame.sequence;
        if (std::ranges::find(sequences, name) == sequences.end())
            sequences.push_back(name);
    }
    step.settings = settingsText(masked) + settingsOf(project, sequences);
    step.inputs = clipInputs(project, sequences);
    step.inputs.push_back(appearanceModelStep(work->entry.name));
    step.files = [work, sequences](const Progress& progress) {
        std::vector<std::filesystem::path> files = filesOf(*work->opener, sequences, progress);
        for (const CompletionEntry& completion : work->entry.completions) {
            if (!completion.mask.empty())
                files.push_back(resolvePath(completion.mask, work->opener->folder()));
        }
        return files;
    };
    step.compute = [work](const StepContext& context, const Progress& progress) {
        const ResultPointer stored = context.resultOf(appearanceModelStep(work->entry.name));
        const auto model = std::make_shared<const AppearanceModel>(
            readAppearanceFile(modelFileOf(*stored, work->opener->folder())));
        const AppearanceDecoder decoder(model);
        const ChartLookup charts(model->texels);
        std::vector<CompletedFrame> frames;
        const auto count = static_cast<double>(work->entry.completions.size());
        for (const CompletionEntry& completion : work->entry.completions) {
            const auto done = static_cast<double>(frames.size());
            frames.push_back(complete(*work, decoder, charts, completion,
                                      progress.part(done / count, (done + 1) / count)));
        }
        Result result = completionsResult(frames);
        for (const CompletedFrame& frame : frames)
            result.files.push_back(work->written(frame.file, progress));
        return result;
    };
    return step;
}

} // namespace

std::vector<BuildStep> makeAppearanceSteps(const StepMaking& making)
{
    std::vector<BuildStep> steps;
    for (const AppearanceEntry& entry : making.opener->project().appearances) {
        const auto work =
            std::make_shared<const AppearanceWork>(AppearanceWork{making.opener, entry, making.projectFile});
        steps.push_back(modelStep(work));
        if (!entry.completions.empty())
            steps.push_back(completionsStep(work));
        if (learnsPoses(making.opener->project(), entry))
            steps.push_back(posesStep(work));
    }
    return steps;
}

} // namespace quadrille

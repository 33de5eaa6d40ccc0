// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/bounds.h"
#include "model/project/document/findentry.h"
#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/buildstep.h"
#include "model/sequence/contacts.h"

#include <cmath>

namespace quadrille {

namespace {

using Opener = std::shared_ptr<SequenceOpener>;

DataArray arrayOf(std::string name, std::string description, std::string unit,
                  std::vector<std::string> columns, std::vector<float> values)
{
    DataArray array;
    const auto width = static_cast<std::int64_t>(columns.size());
    array.shape = {static_cast<std::int64_t>(values.size()) / width, width};
    array.name = std::move(name);
    array.description = std::move(description);
    array.unit = std::move(unit);
    array.columns = std::move(columns);
    array.values = std::move(values);
    return array;
}

struct Measures
{
    std::vector<float> bounds;   ///< frames × 6
    std::vector<float> centroid; ///< frames × 3
};

/// \return per frame the box around the vertices and their mean.
Measures measure(const MeshSequence& sequence, const Progress& progress)
{
    Measures measures;
    for (std::int64_t f = 0; f < sequence.frameCount(); ++f) {
        progress.report(f, sequence.frameCount());
        const Frame frame = sequence.frame(FrameIndex(f));
        const Bounds bounds = boundsOf(frame.positions());
        const Vec3f low = bounds.min.cast<float>();
        const Vec3f high = bounds.max.cast<float>();
        Vec3d sum = Vec3d::Zero();
        for (const Vec3f& p : frame.positions())
            sum += p.cast<double>();
        const Vec3f mean = (sum / static_cast<double>(frame.positions().size())).cast<float>();
        measures.bounds.insert(measures.bounds.end(), low.begin(), low.end());
        measures.bounds.insert(measures.bounds.end(), high.begin(), high.end());
        measures.centroid.insert(measures.centroid.end(), mean.begin(), mean.end());
    }
    return measures;
}

DataTable contactTable(const std::vector<ContactSpan>& contacts, bool given)
{
    std::vector<std::string> feet;
    std::vector<std::int64_t> first;
    std::vector<std::int64_t> last;
    for (const ContactSpan& span : contacts) {
        feet.push_back(span.foot);
        first.push_back(span.frames.first.value);
        last.push_back(span.frames.last.value);
    }
    DataTable table;
    table.name = "contacts";
    table.description = given ? "When which foot stands, as the project says."
                              : "When which foot stands, found by height and speed of the lowest vertices.";
    table.columns = {columnOf("foot", "", std::move(feet)), columnOf("first", "frame", std::move(first)),
                     columnOf("last", "frame", std::move(last))};
    return table;
}

BuildStep statisticsStep(const Opener& opener, const SequenceEntry& entry)
{
    const Project& project = opener->project();
    BuildStep step;
    step.name = "sequences/" + entry.name + "/statistics";
    step.version = 4;
    step.dataPrefix = "sequences/" + entry.name;
    step.settings = sequenceSettings(project, entry) + contactSettings(entry);
    step.inputs = clipInputs(project, {entry.name});
    step.files = [opener, name = entry.name](const Progress& progress) {
        return opener->filesOf(name, progress);
    };
    step.compute = [opener, entry](const StepContext& context, const Progress& progress) {
        const auto opened = opener->open(entry.name, progress.part(0, 0.1));
        for (const Issue& issue : opened->issues)
            context.tell(issue);
        const MeshSequence& sequence = opened->sequence;
        const std::string unit = unitText(opener->project().settings.axes.metresPerUnit);
        Measures measures = measure(sequence, progress.part(0.1, 0.5));
        ContactOptions options;
        options.up = opener->project().settings.axes.up;
        const bool given = !sequence.contacts.empty();
        const auto found =
            given ? sequence.contacts : detectContacts(sequence, options, progress.part(0.5, 1));
        Result result;
        result.arrays = {arrayOf("bounds", "Box around the vertices of each frame.", unit,
                                 {"min-x", "min-y", "min-z", "max-x", "max-y", "max-z"},
                                 std::move(measures.bounds)),
                         arrayOf("centroid", "Mean of the vertices of each frame.", unit, {"x", "y", "z"},
                                 std::move(measures.centroid))};
        result.tables = {contactTable(found, given)};
        return result;
    };
    return step;
}

/// The table of all frames of one character, in the order of the project's sequences.
BuildStep framesStep(const Opener& opener, const std::string& character)
{
    const Project& project = opener->project();
    const std::vector<std::string> names = sequencesOfGraph(project, character);
    BuildStep step;
    step.name = project.characters.size() > 1 ? "frames/" + character : "frames";
    step.character = character;
    step.inputs = clipInputs(project, names);
    step.settings = sequenceSettings(project, names);
    step.files = [opener, names](const Progress& progress) {
        std::vector<std::filesystem::path> files;
        for (const std::string& name : names) {
            const auto own = opener->filesOf(name, progress);
            files.insert(files.end(), own.begin(), own.end());
        }
        return files;
    };
    step.compute = [opener, names](const StepContext&, const Progress& progress) {
        std::vector<std::int64_t> index;
        std::vector<std::string> sequence;
        std::vector<std::int64_t> frame;
        for (const std::string& name : names) {
            const std::int64_t count = opener->open(name, progress)->sequence.frameCount();
            for (std::int64_t f = 0; f < count; ++f) {
                index.push_back(static_cast<std::int64_t>(index.size()));
                sequence.push_back(name);
                frame.push_back(f);
            }
        }
        Result result;
        result.tables = {
            {"frames",
             "All frames of the character's sequences, in the order of the project.",
             {columnOf("index", "", std::move(index)), columnOf("sequence", "", std::move(sequence)),
              columnOf("frame", "frame", std::move(frame))}}};
        return result;
    };
    return step;
}

} // namespace

std::vector<BuildStep> makeSequenceSteps(const StepMaking& making)
{
    const Project& project = making.opener->project();
    std::vector<BuildStep> steps;
    for (const SequenceEntry& entry : project.sequences)
        steps.push_back(statisticsStep(making.opener, entry));
    if (project.characters.empty() && !project.sequences.empty())
        steps.push_back(framesStep(making.opener, ""));
    for (const CharacterEntry& character : project.characters)
        steps.push_back(framesStep(making.opener, character.name));
    return steps;
}

} // namespace quadrille

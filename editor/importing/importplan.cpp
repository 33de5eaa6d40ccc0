// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/importing/importplan.h"

#include "editor/commands/projectedits.h"
#include "editor/documents/projectdocument.h"
#include "model/project/document/entryname.h"
#include "model/sequence/meshsequence.h"

#include <algorithm>

namespace quadrille {

namespace {

/// The mesh's name, or its folder's where it is just "mesh".
std::string nameAfter(const std::filesystem::path& file)
{
    const std::string stem = file.stem().string();
    const std::string folder = file.parent_path().filename().string();
    const bool isPlain = stem.empty() || stem == "mesh" || stem.find('#') != std::string::npos;
    const std::string name = isPlain ? folder : stem;
    return problemWithName(name) ? "Character" : name;
}

bool fits(const CharacterEntry& character, const ImportPlan& plan)
{
    return plan.mesh.empty() || character.mesh.empty() || character.mesh == plan.mesh.string();
}

/// What has times and no frames of its own has as many frames as its rate makes.
void sample(PlannedTake& planned)
{
    const SurveyedTake& take = planned.take;
    if (!take.isSampled || take.hasOwnFps || !take.sequence || take.sequence->fps == planned.rate.fps)
        return;
    planned.take.sequence = resampled(*take.sequence, planned.rate.fps);
    planned.range.reset();
}

} // namespace

std::vector<const PlannedTake*> ImportPlan::wanted() const
{
    std::vector<const PlannedTake*> result;
    for (const PlannedTake& planned : takes) {
        if (planned.isWanted && planned.canBeImported())
            result.push_back(&planned);
    }
    return result;
}

bool ImportPlan::isRateUnknown(const PlannedTake& planned)
{
    return planned.canBeImported() && !planned.take.hasOwnFps && !planned.isRateChosen &&
           planned.rate.isGuess() && planned.take.sequence->frameCount() > 1;
}

std::vector<const PlannedTake*> ImportPlan::withUnknownRate() const
{
    std::vector<const PlannedTake*> result = wanted();
    std::erase_if(result, [](const PlannedTake* planned) { return !isRateUnknown(*planned); });
    return result;
}

void ImportPlan::setRate(const PlannedTake& planned, double fps)
{
    const double before = planned.rate.fps;
    for (PlannedTake& each : takes) {
        if (each.take.hasOwnFps || each.rate.fps != before)
            continue;
        each.rate.fps = fps;
        each.isRateChosen = true;
        sample(each);
    }
}

double ImportPlan::heightOf(const SurveyedTake& take) const
{
    const CoordinateSystem system = take.coordinates ? CoordinateSystem{} : axes;
    const auto up = static_cast<Eigen::Index>(system.up == UpAxis::X ? 0 : system.up == UpAxis::Y ? 1 : 2);
    return static_cast<double>(take.size[up]) * system.metresPerUnit;
}

SurveyOptions surveyOptions(const std::filesystem::path& mesh, const Project& project)
{
    SurveyOptions options{.mesh = mesh, .knownMeshes = {}, .fps = project.settings.fps};
    for (const CharacterEntry& character : project.characters) {
        if (!character.mesh.empty())
            options.knownMeshes.emplace_back(character.mesh);
    }
    return options;
}

ImportPlan planFor(std::vector<SurveyedTake> takes, const std::filesystem::path& mesh, const Project& project)
{
    ImportPlan plan;
    plan.axes = project.settings.axes;
    plan.mesh = mesh;
    for (SurveyedTake& take : takes) {
        if (plan.mesh.empty())
            plan.mesh = take.mesh;
        PlannedTake planned{.take = std::move(take), .name = {}, .range = {}, .texture = {}};
        planned.name = planned.take.name;
        plan.takes.push_back(std::move(planned));
    }
    const auto opened = std::ranges::find_if(
        plan.takes, [](const PlannedTake& each) { return each.canBeImported() && !each.take.coordinates; });
    if (opened != plan.takes.end()) {
        plan.axes.metresPerUnit = 1;
        plan.axes.metresPerUnit = likelyMetresPerUnit(plan.heightOf(opened->take));
    }
    const auto known = std::ranges::find_if(
        project.characters, [&plan](const CharacterEntry& character) { return fits(character, plan); });
    if (known != project.characters.end())
        plan.character = known->name;
    else if (!plan.takes.empty())
        plan.character = nameAfter(plan.mesh.empty() ? plan.takes.front().take.source : plan.mesh);
    for (PlannedTake& planned : plan.takes) {
        planned.rate = takenRate(planned.take.rate, project, plan.character);
        sample(planned);
    }
    return plan;
}

QStringList carryOut(const ImportPlan& plan, ProjectDocument& document)
{
    const Project& project = document.project();
    const auto wanted = plan.wanted();
    double fps = project.settings.fps;
    if (project.sequences.empty() && !wanted.empty())
        fps = wanted.front()->take.hasOwnFps ? wanted.front()->take.sequence->fps : wanted.front()->rate.fps;
    std::vector<SequenceEntry> entries;
    for (const PlannedTake* planned : wanted) {
        SequenceEntry entry;
        entry.name = planned->name;
        entry.character = plan.character;
        entry.source = planned->take.source.string();
        entry.clip = planned->take.clip;
        entry.range = planned->range;
        entry.texture = planned->texture;
        entry.jointAngles = planned->take.jointAngles.string();
        if (!planned->take.hasOwnFps && planned->rate.fps != fps)
            entry.sourceFps = planned->rate.fps;
        if (!planned->take.coordinates && plan.axes != CoordinateSystem{})
            entry.sourceAxes = plan.axes;
        entries.push_back(std::move(entry));
    }
    std::vector<CharacterEntry> characters;
    if (document.character(QString::fromStdString(plan.character)) == nullptr) {
        CharacterEntry& character = characters.emplace_back();
        character.name = plan.character;
        character.mesh = plan.mesh.string();
    }
    return addSequences(document, std::move(entries), std::move(characters), fps);
}

} // namespace quadrille

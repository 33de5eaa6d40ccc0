// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/validate.h"

#include "model/project/clipdependencies.h"
#include "model/project/madeclips.h"
#include "model/project/opensequence.h"
#include "model/project/paths.h"
#include "model/project/validateamounts.h"
#include "model/project/validateanimations.h"
#include "model/project/validateevaluations.h"
#include "model/project/validatevariations.h"
#include "model/project/validationtexts.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace quadrille {

namespace {

constexpr double lowestFps = 0.001;
constexpr double highestFps = 10000;
constexpr std::size_t longestFileName = 255; ///< bytes, of Linux's file systems

class Validator
{
public:
    explicit Validator(const Project& project) : m_project(project) {}

    ProjectProblems run()
    {
        checkFps(m_project.settings.fps, "/settings/fps");
        checkNames(m_project.characters, "/characters");
        checkNames(m_project.sequences, "/sequences");
        checkNames(m_project.animations, "/animations");
        checkNames(m_project.variations, "/variations");
        checkNames(m_project.exports, "/exports");
        for (std::size_t i = 0; i < m_project.characters.size(); ++i)
            checkCharacter(m_project.characters[i], "/characters/" + std::to_string(i));
        for (std::size_t i = 0; i < m_project.sequences.size(); ++i)
            checkSequence(m_project.sequences[i], "/sequences/" + std::to_string(i));
        checkCycles();
        checkGraphs();
        validateAnimations(m_project, m_problems);
        validateAmounts(m_project, m_problems);
        validateVariations(m_project, m_problems);
        validateEvaluations(m_project, m_problems);
        for (std::size_t i = 0; i < m_project.exports.size(); ++i)
            checkExport(m_project.exports[i], "/exports/" + std::to_string(i));
        return std::move(m_problems);
    }

private:
    void invalid(std::string pointer, std::string reason, std::string remedy = {})
    {
        m_problems.push_back(invalidAt(std::move(pointer), std::move(reason), std::move(remedy)));
    }

    void checkFps(double fps, const std::string& pointer)
    {
        if (!(fps >= lowestFps) || fps > highestFps)
            invalid(pointer, "A frame rate must be from 0.001 to 10000 frames a second");
    }

    template <typename Entry>
    void checkNames(const std::vector<Entry>& entries, const std::string& section)
    {
        std::set<std::string> seen;
        for (std::size_t i = 0; i < entries.size(); ++i) {
            const std::string pointer = section + "/" + std::to_string(i) + "/name";
            if (const auto reason = problemWithName(entries[i].name))
                invalid(pointer, *reason);
            else if (!seen.insert(entries[i].name).second)
                invalid(pointer, "There are two entries with the name " + quoted(entries[i].name) + " here",
                        "Give one of them another name.");
        }
    }

    void checkPath(const std::string& path, const std::string& pointer)
    {
        for (const auto& part : std::filesystem::path(path)) {
            if (part.native().size() > longestFileName)
                invalid(pointer,
                        "The path has a file name of more than " + std::to_string(longestFileName) +
                            " bytes, which no disk can hold",
                        "Choose a shorter name.");
        }
        if (path.find('\\') != std::string::npos) {
            m_problems.push_back(warningAt(pointer, "The path " + quoted(path) + " has backslashes",
                                           "Write forward slashes, on every system."));
        } else if (!path.empty() && std::filesystem::path(path).is_absolute()) {
            m_problems.push_back(warningAt(pointer,
                                           "The path " + quoted(path) + " holds for this machine only",
                                           "Write it relative to the project file."));
        }
    }

    void checkTexture(const TextureReference& texture, const std::string& pointer)
    {
        for (const std::string& path : texture.paths)
            checkPath(path, pointer + "/texture");
    }

    void checkRange(const std::optional<FrameRange>& range, const std::string& pointer)
    {
        if (range && range->count() == 0)
            invalid(pointer, "The range ends before it begins",
                    "Write [first, last], zero-based, both included.");
    }

    void checkCharacter(const CharacterEntry& character, const std::string& pointer)
    {
        checkPath(character.mesh, pointer + "/mesh");
        checkTexture(character.texture, pointer);
    }

    void checkGraph(const GraphEntry& graph, const std::string& pointer)
    {
        const auto known = namesOf(m_project.characters);
        if (graph.character.empty() && known.size() > 1)
            invalid(pointer, "“character” is missing here", "The project has several characters.");
        else if (!graph.character.empty() &&
                 std::find(known.begin(), known.end(), graph.character) == known.end())
            invalid(pointer + "/character", "There is no character " + quoted(graph.character),
                    meantOr(graph.character, known, "Add it under “characters”."));
        if (!(graph.pose.stretchWeight >= 0))
            invalid(pointer + "/stretch_weight", "The weight of the stretch is below zero");
        if (!(graph.steps.contacts >= 0))
            invalid(pointer + "/contact_weight", "The weight of contacts is below zero");
        if (!(graph.steps.velocity >= 0))
            invalid(pointer + "/velocity_weight", "The weight of velocities is below zero");
        if (graph.slope < TransitionSettings::leastSlope || graph.slope > TransitionSettings::greatestSlope)
            invalid(pointer + "/slope", "The slope must be 2, 3, 4 or 5");
        if (graph.durations &&
            (!(graph.durations->first > 0) || !(graph.durations->second >= graph.durations->first)))
            invalid(pointer + "/durations", "Durations must be [shortest, longest] in seconds, above zero");
        if (!(graph.alpha >= 0))
            invalid(pointer + "/alpha", "Alpha is below zero", "Write 0.01, or more to favour short walks.");
        if (graph.greatestDistance && !(*graph.greatestDistance > 0))
            invalid(pointer + "/d_max", "The largest pose distance must be above zero",
                    "Leave it out to take the largest of the character.");
    }

    void checkGraphs()
    {
        std::set<std::string> seen;
        for (std::size_t i = 0; i < m_project.graphs.size(); ++i) {
            const GraphEntry& graph = m_project.graphs[i];
            const std::string pointer = "/graph/" + std::to_string(i);
            checkGraph(graph, m_project.graphs.size() == 1 && graph.character.empty() ? "/graph" : pointer);
            if (!seen.insert(graph.character).second)
                invalid(pointer, "There are two graphs of one character here", "Leave one of them out.");
        }
    }

    void checkSequence(const SequenceEntry& sequence, const std::string& pointer)
    {
        checkCharacterOf(sequence, pointer);
        checkRange(sequence.range, pointer + "/range");
        if (sequence.sourceFps)
            checkFps(*sequence.sourceFps, pointer + "/source_fps");
        checkSource(sequence, pointer);
        checkTexture(sequence.texture, pointer);
        checkPath(sequence.jointAngles, pointer + "/joint_angles");
        checkSpans(sequence.labels, &LabelSpan::label, pointer + "/labels/", "label");
        checkSpans(sequence.contacts, &ContactSpan::foot, pointer + "/contacts/", "foot");
    }

    void checkCharacterOf(const SequenceEntry& sequence, const std::string& pointer)
    {
        const auto known = namesOf(m_project.characters);
        if (sequence.character.empty()) {
            if (known.size() > 1)
                invalid(pointer, "“character” is missing here", "The project has several characters.");
        } else if (std::find(known.begin(), known.end(), sequence.character) == known.end()) {
            invalid(pointer + "/character", "There is no character " + quoted(sequence.character),
                    meantOr(sequence.character, known, "Add it under “characters”."));
        }
    }

    template <typename Span>
    void checkSpans(const std::vector<Span>& spans, std::string Span::*text, const std::string& pointer,
                    const std::string& textKey)
    {
        for (std::size_t i = 0; i < spans.size(); ++i) {
            const std::string place = pointer + std::to_string(i) + "/";
            if ((spans[i].*text).empty())
                invalid(place + textKey, quoted(textKey).append(" is empty here"));
            checkRange(spans[i].frames, place + "frames");
        }
    }

    void checkSource(const SequenceEntry& sequence, const std::string& pointer)
    {
        const auto clip = clipOfSource(sequence.source);
        if (clip && variationOfClip(*clip).value_or(VariationNumber{{}, 1}).number == 0)
            invalid(pointer + "/source", quoted(*clip) + " names all variations",
                    "Name one of them, as in “" + *clip + "/1”.");
        else if (clip)
            checkClip(*clip, pointer + "/source");
        else if (sequence.source.empty())
            invalid(pointer + "/source", "The source is empty", "Name a file, a series or a clip.");
        else
            checkPath(sequence.source, pointer + "/source");
    }

    /// A clip "SECTION/NAME" must exist; sections of later capabilities are not looked into.
    void checkClip(const std::string& clip, const std::string& pointer)
    {
        const auto slash = clip.find('/');
        const std::string section = clip.substr(0, slash);
        const std::string name = slash == std::string::npos ? "" : clip.substr(slash + 1);
        if (name.empty()) {
            invalid(pointer, quoted(clip) + " names no clip", "Write SECTION/NAME, as in “sequences/walk”.");
        } else if (section == "animations") {
            const auto known = namesOf(m_project.animations);
            if (std::find(known.begin(), known.end(), name) == known.end())
                invalid(pointer, "There is no animation " + quoted(name),
                        meantOr(name, known, "Correct the name."));
        } else if (section == "variations") {
            checkVariationClip(clip, pointer);
        } else if (section != "sequences") {
            if (m_project.unknown.is_object() && m_project.unknown.contains(section))
                m_problems.push_back(warningAt(pointer, "Clips of the section " + quoted(section) +
                                                            " cannot be used by this version"));
            else
                invalid(pointer, "The project has no section " + quoted(section) + " with clips");
        } else {
            const auto known = namesOf(m_project.sequences);
            if (std::find(known.begin(), known.end(), name) == known.end())
                invalid(pointer, "There is no sequence " + quoted(name),
                        meantOr(name, known, "Correct the name."));
        }
    }

    void checkVariationClip(const std::string& clip, const std::string& pointer)
    {
        const auto varied = variationOfClip(clip);
        const auto known = namesOf(m_project.variations);
        const VariationEntry* entry = varied ? findVariation(m_project, varied->variation) : nullptr;
        if (!varied)
            invalid(pointer, quoted(clip) + " names no variation",
                    "Write variations/NAME/NUMBER, with numbers from 1.");
        else if (entry == nullptr)
            invalid(pointer, "There are no variations " + quoted(varied->variation),
                    meantOr(varied->variation, known, "Correct the name."));
        else if (varied->number > variationCount(*entry))
            m_problems.push_back(warningAt(pointer,
                                           quoted(varied->variation) + " has only " +
                                               std::to_string(variationCount(*entry)) + " variations",
                                           "Draw more of them, or name another."));
    }

    /// The way from a clip back to itself; empty when there is none.
    std::vector<std::string> circleOf(const std::string& clip) const
    {
        std::set<std::string> seen;
        std::vector<std::vector<std::string>> ways{{clip}};
        while (!ways.empty()) {
            const std::vector<std::string> way = ways.back();
            ways.pop_back();
            for (const std::string& source : shownBy(m_project, way.back())) {
                std::vector<std::string> longer = way;
                longer.push_back(source);
                if (source == clip)
                    return longer;
                if (seen.insert(source).second)
                    ways.push_back(std::move(longer));
            }
        }
        return {};
    }

    void checkCycles()
    {
        for (std::size_t i = 0; i < m_project.sequences.size(); ++i) {
            std::string way;
            for (const std::string& clip : circleOf("sequences/" + m_project.sequences[i].name))
                way += (way.empty() ? "" : " → ") + clip.substr(clip.find('/') + 1);
            if (!way.empty())
                invalid("/sequences/" + std::to_string(i) + "/source",
                        "The sequence is its own source: " + way, "Break the circle.");
        }
    }

    void checkExport(const ExportEntry& entry, const std::string& pointer)
    {
        if (!entry.what.empty())
            checkClip(entry.what, pointer + "/what");
        if (entry.path.empty())
            invalid(pointer + "/path", "The path is empty", "Name the file to write.");
        checkPath(entry.path, pointer + "/path");
        checkRange(entry.range, pointer + "/range");
        if (entry.fps)
            checkFps(*entry.fps, pointer + "/fps");
    }

    const Project& m_project;
    ProjectProblems m_problems;
};

} // namespace

std::optional<std::string> problemWithName(const std::string& name)
{
    if (name.empty())
        return "The name is empty";
    if (name == "." || name == "..")
        return "“" + name + "” cannot be a name";
    const bool unusable = std::any_of(name.begin(), name.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return c == '/' || c == '\\' || byte < 0x20 || byte == 0x7F;
    });
    if (unusable)
        return "A name has no slashes and no control characters";
    if (name.size() > longestName)
        return "The name is too long: it has " + std::to_string(name.size()) +
               " bytes, and files of results and exports can be named by " + std::to_string(longestName);
    return std::nullopt;
}

ProjectProblems validate(const Project& project)
{
    return Validator(project).run();
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validate.h"

#include "model/project/checks/validateanimations.h"
#include "model/project/checks/validateappearances.h"
#include "model/project/checks/validateevaluations.h"
#include "model/project/checks/validatelives.h"
#include "model/project/checks/validatemotionspaces.h"
#include "model/project/checks/validatevariations.h"
#include "model/project/document/clipdependencies.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/document/problemtexts.h"
#include "model/project/fields/checkfields.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace quadrille {

namespace {

class Validator
{
public:
    explicit Validator(const Project& project) : m_project(project) {}

    ProjectProblems run()
    {
        checkFields(m_project, m_problems);
        for (std::size_t i = 0; i < m_project.sequences.size(); ++i)
            checkSource(m_project.sequences[i], "/sequences/" + std::to_string(i));
        checkCycles();
        checkGraphs();
        validateAnimations(m_project, m_problems);
        validateVariations(m_project, m_problems);
        validateMotionSpaces(m_project, m_problems);
        validateLives(m_project, m_problems);
        validateAppearances(m_project, m_problems);
        for (std::size_t i = 0; i < m_project.transfers.size(); ++i)
            checkTransfer(m_project.transfers[i], "/transfers/" + std::to_string(i));
        for (std::size_t i = 0; i < m_project.projections.size(); ++i)
            checkShown(m_project.projections[i].clip, "projections/" + m_project.projections[i].name,
                       "/projections/" + std::to_string(i) + "/clip");
        validateEvaluations(m_project, m_problems);
        for (std::size_t i = 0; i < m_project.exports.size(); ++i) {
            if (const std::string& what = m_project.exports[i].what; !what.empty())
                checkClip(what, "/exports/" + std::to_string(i) + "/what");
        }
        return std::move(m_problems);
    }

private:
    void invalid(std::string pointer, std::string reason, std::string remedy = {})
    {
        m_problems.push_back(invalidAt(std::move(pointer), std::move(reason), std::move(remedy)));
    }

    void checkGraphs()
    {
        std::set<std::string> seen;
        for (std::size_t i = 0; i < m_project.graphs.size(); ++i) {
            const GraphEntry& graph = m_project.graphs[i];
            const bool isAlone = m_project.graphs.size() == 1 && graph.character.empty();
            const std::string pointer = isAlone ? "/graph" : "/graph/" + std::to_string(i);
            if (graph.durations &&
                (!(graph.durations->first > 0) || !(graph.durations->second >= graph.durations->first)))
                invalid(pointer + "/durations",
                        "Durations must be [shortest, longest] in seconds, above zero");
            else if (graph.durations && !(graph.durations->second <= longestWindow))
                invalid(pointer + "/durations", "A transition has at most 60 seconds", "Write less.");
            if (!seen.insert(graph.character).second)
                invalid(pointer, "There are two graphs of one character here", "Leave one of them out.");
        }
    }

    void checkSource(const SequenceEntry& sequence, const std::string& pointer)
    {
        if (const auto clip = clipOfSource(sequence.source))
            checkOne(*clip, pointer + "/source");
    }

    /// A clip that is one alone.
    void checkOne(const std::string& clip, const std::string& pointer)
    {
        if (const auto varied = variationOfClip(clip); varied && varied->number == 0)
            invalid(pointer, quoted(clip) + " names all variations",
                    "Name one of them, as in “" + clip + "/1”.");
        else
            checkClip(clip, pointer);
    }

    /// The clip that another one is made of.
    void checkShown(const std::string& clip, const std::string& made, const std::string& pointer)
    {
        checkOne(clip, pointer);
        if (isMadeOfItself(m_project, made))
            invalid(pointer, quoted(made.substr(made.find('/') + 1)) + " is made of itself",
                    "Break the circle.");
    }

    void checkTransfer(const TransferEntry& transfer, const std::string& pointer)
    {
        checkShown(transfer.clip, "transfers/" + transfer.name, pointer + "/clip");
        if (!transfer.truth.empty())
            checkOne(transfer.truth, pointer + "/truth");
        std::set<TriangleIndex> seen;
        for (std::size_t i = 0; i < transfer.pairs.size(); ++i) {
            if (!seen.insert(transfer.pairs[i].onTarget).second)
                invalid(pointer + "/pairs/" + std::to_string(i),
                        "Triangle " + std::to_string(transfer.pairs[i].onTarget.value) +
                            " of the target is in two pairs",
                        "Remove one of them.");
        }
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
        } else if (section == "live") {
            const auto known = namesOf(m_project.lives);
            if (std::find(known.begin(), known.end(), name) == known.end())
                invalid(pointer, "There is no live performance " + quoted(name),
                        meantOr(name, known, "Correct the name."));
        } else if (section == "transfers") {
            const auto known = namesOf(m_project.transfers);
            if (std::find(known.begin(), known.end(), name) == known.end())
                invalid(pointer, "There is no transfer " + quoted(name),
                        meantOr(name, known, "Correct the name."));
        } else if (section == "projections") {
            const auto known = namesOf(m_project.projections);
            if (std::find(known.begin(), known.end(), name) == known.end())
                invalid(pointer, "There is no projection " + quoted(name),
                        meantOr(name, known, "Correct the name."));
        } else if (section == "variations") {
            checkVariationClip(clip, pointer);
        } else if (section != "sequences") {
            if (m_project.unknown.contains(section))
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

    const Project& m_project;
    ProjectProblems m_problems;
};

} // namespace

ProjectProblems validate(const Project& project)
{
    return Validator(project).run();
}

} // namespace quadrille

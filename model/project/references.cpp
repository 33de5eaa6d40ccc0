// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/references.h"

#include "model/project/paths.h"

#include <algorithm>

namespace quadrille {

namespace {

/// One walk over a project. The `keeps…` functions rename in place and are false where what they look at has
/// to go.
class ReferenceChanger
{
public:
    ReferenceChanger(Project& project, NamedKind kind, const NameChange& change)
        : m_project(project), m_kind(kind), m_change(change)
    {
        if (project.characters.size() == 1)
            m_onlyCharacter = project.characters.front().name;
    }

    LostEntries run()
    {
        LostEntries lost;
        std::erase_if(m_project.sequences, [&](SequenceEntry& entry) {
            return !(keepsCharacter(entry.character) && keepsSource(entry.source)) &&
                   (lost.sequences.push_back(entry.name), true);
        });
        std::erase_if(m_project.graphs, [&](GraphEntry& graph) { return !keepsCharacter(graph.character); });
        std::erase_if(m_project.animations, [&](AnimationEntry& entry) {
            return !keepsCharacter(entry.character) && (lost.animations.push_back(entry.name), true);
        });
        std::erase_if(m_project.bodyParts, [&](BodyPartsEntry& entry) {
            if (m_kind == NamedKind::Sequence && entry.pose && !keeps(entry.pose->sequence))
                entry.pose.reset();
            return !keepsCharacter(entry.character);
        });
        std::erase_if(m_project.variations, [&](VariationEntry& entry) {
            return !(keepsCharacter(entry.character) && keepsTakes(entry)) &&
                   (lost.variations.push_back(entry.name), true);
        });
        // An evaluation without a character is of all of them.
        std::erase_if(m_project.evaluations, [&](EvaluationEntry& entry) {
            return !entry.character.empty() && !keepsCharacter(entry.character);
        });
        if (m_kind == NamedKind::Variation) {
            for (AnimationEntry& animation : m_project.animations)
                changeVariations(animation.post.variations);
        }
        std::erase_if(m_project.exports, [&](ExportEntry& entry) { return !keepsClip(entry.what); });
        if (m_kind == NamedKind::Sequence) {
            for (AnimationEntry& animation : m_project.animations)
                changeSequences(animation);
            for (EvaluationEntry& evaluation : m_project.evaluations)
                changeSequences(evaluation);
        }
        return lost;
    }

private:
    bool keeps(std::string& name) const
    {
        if (name.empty())
            return true;
        auto changed = m_change(name);
        if (changed)
            name = std::move(*changed);
        return changed.has_value();
    }

    bool keepsBoth(std::string& first, std::string& second) const
    {
        const bool keepsFirst = keeps(first);
        return keeps(second) && keepsFirst;
    }

    /// No name stands for the only character.
    bool keepsCharacter(std::string& name) const
    {
        if (m_kind != NamedKind::Character)
            return true;
        return name.empty() ? !m_onlyCharacter || m_change(*m_onlyCharacter) : keeps(name);
    }

    bool keepsClip(std::string& clip) const
    {
        if (m_kind == NamedKind::Character)
            return true;
        const std::string section = sectionOf(m_kind);
        auto name = nameOfClip(clip, section);
        if (!name)
            return true;
        // Clips of variations have a number behind the name.
        std::string number;
        if (m_kind == NamedKind::Variation)
            number = cutNumber(*name);
        if (!keeps(*name))
            return false;
        clip = section + "/" + *name + number;
        return true;
    }

    static std::string sectionOf(NamedKind kind)
    {
        return kind == NamedKind::Sequence    ? "sequences"
               : kind == NamedKind::Animation ? "animations"
                                              : "variations";
    }

    /// Takes "/3" off a name.
    static std::string cutNumber(std::string& name)
    {
        const auto slash = std::min(name.find('/'), name.size());
        std::string number = name.substr(slash);
        name.resize(slash);
        return number;
    }

    /// The takes, blends and samples of a variation; without a take left it goes.
    bool keepsTakes(VariationEntry& entry) const
    {
        if (m_kind != NamedKind::Sequence)
            return true;
        const bool hadTakes = !entry.training.empty();
        std::erase_if(entry.training, [&](TrainingEntry& take) { return !keeps(take.sequence); });
        std::erase_if(entry.blends, [&](BlendEntry& blend) {
            const bool keepsAcross = !blend.across || keepsBoth(blend.across->from, blend.across->to);
            return !keepsBoth(blend.from, blend.to) || !keepsAcross;
        });
        std::erase_if(entry.samples, [&](SamplesEntry& samples) {
            const bool keepsAcross = !samples.across || keepsBoth(samples.across->of, samples.across->to);
            return !keepsBoth(samples.of, samples.to) || !keepsAcross;
        });
        if (!keeps(entry.reference))
            entry.reference.clear();
        if (entry.templatePose && !keeps(entry.templatePose->sequence))
            entry.templatePose.reset();
        return !hadTakes || !entry.training.empty();
    }

    bool keepsSource(std::string& source) const
    {
        auto clip = clipOfSource(source);
        if (!clip)
            return true;
        if (!keepsClip(*clip))
            return false;
        source = "clip:" + *clip;
        return true;
    }

    bool keepsConstraint(ConstraintEntry& constraint) const
    {
        if (auto* key = std::get_if<KeyEntry>(&constraint))
            return keeps(key->sequence);
        if (auto* action = std::get_if<ActionEntry>(&constraint))
            return keeps(action->frames.sequence);
        std::erase_if(std::get<PathEntry>(constraint).spans, [&](PathSpanEntry& span) {
            if (span.frames && !keeps(span.frames->sequence))
                span.frames.reset();
            return !span.frames && !span.duration;
        });
        return true;
    }

    void changeVariations(std::optional<VariedRepeats>& repeats) const
    {
        if (repeats && !keeps(repeats->from))
            repeats.reset();
    }

    void changeSequences(AnimationEntry& animation) const
    {
        if (animation.start && !keeps(animation.start->sequence))
            animation.start.reset();
        std::erase_if(animation.constraints, [&](ConstraintEntry& each) { return !keepsConstraint(each); });
        for (auto* junctions :
             {&animation.junctions.banned, &animation.junctions.locked, &animation.junctions.chosen})
            std::erase_if(*junctions, [&](JunctionEntry& junction) {
                const bool keepsFrom = keeps(junction.from.sequence);
                return !keeps(junction.to.sequence) || !keepsFrom;
            });
        // A walk with a part missing is none.
        const auto keepsWalk = [&](std::vector<WalkSpanEntry>& spans) {
            return std::all_of(spans.begin(), spans.end(),
                               [&](WalkSpanEntry& span) { return keeps(span.sequence); });
        };
        if (animation.walk && !keepsWalk(animation.walk->spans))
            animation.walk.reset();
        if (!keepsWalk(animation.junctions.walk))
            animation.junctions.walk.clear();
    }

    void changeSequences(EvaluationEntry& evaluation) const
    {
        const auto before = evaluation.sequences.size();
        std::erase_if(evaluation.sequences, [&](std::string& name) { return !keeps(name); });
        // The other tables are of two sequences.
        if (evaluation.table != "table2" && evaluation.sequences.size() != before)
            evaluation.sequences.clear();
    }

    Project& m_project;
    NamedKind m_kind;
    const NameChange& m_change;
    std::optional<std::string> m_onlyCharacter;
};

/// Calls a function with the entries of a kind.
template <typename Function>
void withEntries(Project& project, NamedKind kind, const Function& function)
{
    switch (kind) {
    case NamedKind::Character:
        function(project.characters);
        return;
    case NamedKind::Sequence:
        function(project.sequences);
        return;
    case NamedKind::Animation:
        function(project.animations);
        return;
    case NamedKind::Variation:
        function(project.variations);
        return;
    }
}

} // namespace

LostEntries changeReferences(Project& project, NamedKind kind, const NameChange& change)
{
    return ReferenceChanger(project, kind, change).run();
}

void renameEntry(Project& project, NamedKind kind, const std::string& before, const std::string& after)
{
    changeReferences(project, kind, [&](const std::string& name) { return name == before ? after : name; });
    withEntries(project, kind, [&](auto& entries) {
        for (auto& entry : entries) {
            if (entry.name == before)
                entry.name = after;
        }
    });
}

void nameOnlyCharacter(Project& project)
{
    const auto nameIn = [name = project.characters.front().name](auto& entries) {
        for (auto& entry : entries) {
            if (entry.character.empty())
                entry.character = name;
        }
    };
    nameIn(project.sequences);
    nameIn(project.bodyParts);
    nameIn(project.graphs);
    nameIn(project.animations);
    nameIn(project.variations);
}

void removeEntries(Project& project, NamedKind kind, const std::vector<std::string>& names)
{
    if (names.empty())
        return;
    const auto isGone = [&](const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    const LostEntries lost = changeReferences(project, kind, [&](const std::string& name) {
        return isGone(name) ? std::nullopt : std::optional(name);
    });
    withEntries(project, kind, [&](auto& entries) {
        std::erase_if(entries, [&](const auto& entry) { return isGone(entry.name); });
    });
    removeEntries(project, NamedKind::Sequence, lost.sequences);
    removeEntries(project, NamedKind::Animation, lost.animations);
    removeEntries(project, NamedKind::Variation, lost.variations);
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validatevariations.h"

#include "model/core/contains.h"
#include "model/project/checks/sectionvalidator.h"
#include "model/project/document/blendedges.h"
#include "model/project/document/findentry.h"
#include "model/project/document/problemtexts.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

namespace quadrille {

namespace {

constexpr std::size_t mostBlends = 100; ///< takes that are made by one blend

class PartsValidator : SectionValidator
{
public:
    using SectionValidator::SectionValidator;

    void run(const BodyPartsEntry& entry)
    {
        std::vector<std::string> curves;
        for (const PartCurveEntry& curve : entry.curves)
            curves.push_back(curve.curve.name);
        std::vector<std::string> parts;
        for (const PartEntry& part : entry.parts)
            parts.push_back(part.part.name);
        for (std::size_t i = 0; i < entry.parts.size(); ++i)
            checkPart(entry.parts[i].part, parts, curves, "/parts/" + std::to_string(i));
    }

private:
    void checkPart(const PartDescription& part, const std::vector<std::string>& parts,
                   const std::vector<std::string>& curves, const std::string& key)
    {
        if (!part.parent.empty() && !contains(parts, part.parent))
            warn(key + "/parent", "There is no part " + quoted(part.parent),
                 meantOr(part.parent, parts, "Correct the name."));
        for (std::size_t c = 0; c < part.curves.size(); ++c) {
            if (!contains(curves, part.curves[c]))
                warn(key + "/curves/" + std::to_string(c), "There is no curve " + quoted(part.curves[c]),
                     meantOr(part.curves[c], curves, "Correct the name."));
            else if (std::count(part.curves.begin(), part.curves.end(), part.curves[c]) > 1 && c > 0)
                warn(key + "/curves/" + std::to_string(c),
                     "The part " + quoted(part.name) + " names the curve " + quoted(part.curves[c]) +
                         " twice",
                     "Name two different ones.");
        }
        if (!part.parent.empty() && part.curves.size() != 2)
            warn(key + "/curves",
                 "Two curves bound what the part " + quoted(part.name) + " shares with its parent",
                 "Name both.");
    }
};

class VariationValidator : SectionValidator
{
public:
    using SectionValidator::SectionValidator;

    void run(const VariationEntry& entry)
    {
        checkTraining(entry);
        if (!entry.reference.empty())
            checkTake(entry.reference, "/reference");
        for (std::size_t i = 0; i < entry.blends.size(); ++i)
            checkBlend(entry.blends[i], "/blends/" + std::to_string(i));
        checkBlendsDiffer(entry.blends);
        const HmcSettings& chain = entry.chain;
        if (!(chain.leastAcceptance > 0 && chain.leastAcceptance < chain.greatestAcceptance &&
              chain.greatestAcceptance < 1))
            invalid("/sampling/acceptance", "Shares that are accepted must lie between 0 and 1, ascending",
                    "Write [0.6, 0.9], as usual.");
        if (!(entry.extent.spread >= 0 && entry.extent.spread <= greatestSpread))
            invalid("/sampling/spread", "The spread must be from 0 to 3", "Write 0.7, as usual.");
        const VariationLimits& limits = entry.limits;
        if (!(limits.poseDistance.value_or(1) > 0 && limits.skate > 0 && limits.intersections >= 0 &&
              limits.volumeChange > 0 && limits.collapse >= 0 && limits.sink >= 0))
            invalid("/limits", "A limit of bad variations is below zero");
        for (std::size_t i = 0; i < entry.samples.size(); ++i)
            checkSamples(entry.samples[i], "/samples/" + std::to_string(i));
    }

private:
    void checkTraining(const VariationEntry& entry)
    {
        const std::vector<std::string> own = sequencesOf(characterNameOf(project(), entry));
        if (entry.training.empty())
            warn("", "The variations " + quoted(entry.name) + " have no takes to learn from",
                 "Name them under “sequences”.");
        for (std::size_t i = 0; i < entry.training.size(); ++i) {
            const TrainingEntry& take = entry.training[i];
            const std::string key = "/sequences/" + std::to_string(i);
            if (!contains(own, take.sequence))
                invalid(key, "There is no sequence " + quoted(take.sequence) + " of the character",
                        meantOr(take.sequence, own, "Correct the name."));
            else if (contains(m_takes, take.sequence))
                invalid(key, "The take " + quoted(take.sequence) + " is here twice",
                        "Leave one of them out.");
            m_takes.push_back(take.sequence);
        }
    }

    void checkTake(const std::string& name, const std::string& key)
    {
        if (!contains(m_takes, name))
            invalid(key, quoted(name) + " is none of the takes that are learned",
                    meantOr(name, m_takes, "Name it under “sequences”, too."));
    }

    void checkPair(const std::string& from, const std::string& to, const std::string& key)
    {
        if (from == to)
            invalid(key, "A take cannot be blended with itself", "Name two takes.");
    }

    /// Both further corners of a square. \param others  the keys that they have.
    void checkAcross(const std::array<std::string, 2>& pair, const std::array<std::string, 2>& across,
                     const std::array<const char*, 2>& keys, const std::string& key)
    {
        for (std::size_t i = 0; i < across.size(); ++i) {
            checkTake(across[i], key + keys[i]);
            if (across[i] == pair[0] || across[i] == pair[1] || (i == 1 && across[1] == across[0]))
                invalid(key + keys[i], quoted(across[i]) + " is at two corners of the square",
                        "Name four different takes.");
        }
    }

    void checkWeights(const std::vector<double>& weights, const std::string& key)
    {
        double before = 0;
        for (const double weight : weights) {
            if (!(weight > before && weight < 1)) {
                invalid(key + "/weights", "Weights must lie between 0 and 1, ascending",
                        "Write them like [0.25, 0.5, 0.75].");
                break;
            }
            before = weight;
        }
    }

    void checkBlend(const BlendEntry& blend, const std::string& key)
    {
        checkTake(blend.from, key + "/from");
        checkTake(blend.to, key + "/to");
        checkPair(blend.from, blend.to, key + "/to");
        checkWeights(blend.weights, key);
        const std::size_t nodes =
            (blend.weights.size() + 2) * (blend.across ? blend.across->weights.size() + 2 : 1);
        if (nodes > mostBlends)
            invalid(key, "A blend has at most 100 blended takes");
        if (!blend.across)
            return;
        checkAcross({blend.from, blend.to}, {blend.across->from, blend.across->to}, {"/from", "/to"},
                    key + "/across");
        checkWeights(blend.across->weights, key + "/across");
    }

    /// A blend of two takes, an edge of one of four included, is learned once for each weight.
    void checkBlendsDiffer(const std::vector<BlendEntry>& blends)
    {
        std::set<std::tuple<std::string, std::string, double>> seen;
        for (std::size_t i = 0; i < blends.size(); ++i) {
            for (const BlendEdge& edge : edgesOf(blends[i])) {
                for (const double weight : edge.weights) {
                    const bool isReversed = edge.to < edge.from;
                    const bool isNew = isReversed ? seen.emplace(edge.to, edge.from, 1 - weight).second
                                                  : seen.emplace(edge.from, edge.to, weight).second;
                    if (isNew)
                        continue;
                    invalid("/blends/" + std::to_string(i),
                            quoted(edge.from) + " and " + quoted(edge.to) +
                                " are blended twice at one weight",
                            "Leave one of both out.");
                    break;
                }
            }
        }
    }

    void checkSamples(const SamplesEntry& samples, const std::string& key)
    {
        checkTake(samples.of, key + "/of");
        if (!samples.to.empty()) {
            checkTake(samples.to, key + "/to");
            checkPair(samples.of, samples.to, key + "/to");
        } else if (samples.weight != 0) {
            invalid(key + "/weight", "The weight belongs to no second take", "Name it as “to”.");
        }
        if (!(samples.weight >= 0 && samples.weight <= 1))
            invalid(key + "/weight", "The weight of a blend must be from 0 to 1",
                    "Write 0.5 for half of both.");
        if (samples.across && samples.to.empty()) {
            invalid(key + "/across", "Two takes lie across from one alone", "Name its second as “to”.");
        } else if (samples.across) {
            checkAcross({samples.of, samples.to}, {samples.across->of, samples.across->to}, {"/of", "/to"},
                        key + "/across");
        }
    }

    std::vector<std::string> m_takes;
};

} // namespace

void validateVariations(const Project& project, ProjectProblems& problems)
{
    std::set<std::string> characters;
    for (std::size_t i = 0; i < project.bodyParts.size(); ++i) {
        const BodyPartsEntry& entry = project.bodyParts[i];
        const bool isAlone = project.bodyParts.size() == 1 && entry.character.empty();
        const std::string pointer = isAlone ? "/body_parts" : "/body_parts/" + std::to_string(i);
        PartsValidator(project, pointer, problems).run(entry);
        if (!characters.insert(entry.character).second)
            problems.push_back(invalidAt(pointer, "The parts of one character's body are here twice",
                                         "Leave one of them out."));
    }
    for (std::size_t i = 0; i < project.variations.size(); ++i)
        VariationValidator(project, "/variations/" + std::to_string(i), problems).run(project.variations[i]);
}

} // namespace quadrille

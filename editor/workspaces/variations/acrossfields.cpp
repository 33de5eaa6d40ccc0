// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/acrossfields.h"

#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "model/core/error.h"
#include "model/project/document/blendedges.h"
#include "model/project/steps/variate.h"
#include "widgets/controls/weightspad.h"

#include <QCoreApplication>
#include <QPushButton>
#include <algorithm>

namespace quadrille {

namespace {

struct AcrossTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::AcrossFields)
};

constexpr double onePercent = 0.01;
constexpr std::size_t cornersOfSquare = 4;

bool hasAcross(const SamplesEntry& set)
{
    return set.across.has_value();
}

AcrossSamplesEntry acrossOf(const SamplesEntry& set)
{
    return set.across.value_or(AcrossSamplesEntry());
}

/// Where blends over the square of a set are learned; its corners alone where none are.
std::vector<QPointF> nodesOf(const VariationEntry& entry, const SamplesEntry& set)
{
    std::vector<QPointF> places;
    try {
        for (const LearnedNode& node :
             learnedNodes(blendsOf(entry), entry.training.size(), subjectOf(entry, set)))
            places.emplace_back(node.weight, node.across);
    } catch (const Error&) {
        // The project names takes that there are not; it tells elsewhere.
        places.clear();
    }
    return places;
}

/// \param take  empty: there is none.
void setAcross(SamplesEntry& set, const std::string& take, const std::vector<FieldItem<std::string>>& others)
{
    if (take.empty()) {
        set.across.reset();
        return;
    }
    if (!set.across)
        set.across.emplace().weight = 0.5;
    set.across->of = take;
    const auto isTo = [&](const FieldItem<std::string>& other) { return other.value == set.across->to; };
    if (!others.empty() && std::ranges::none_of(others, isTo))
        set.across->to = others.front().value;
}

void learnSquare(VariationEntry& entry, const SamplesEntry& set)
{
    BlendEntry square;
    square.from = set.of;
    square.to = set.to;
    square.across.emplace();
    square.across->from = set.across->of;
    square.across->to = set.across->to;
    // Its edges are learned with it.
    for (const BlendEdge& edge : edgesOf(square))
        std::erase_if(entry.blends, [&](const BlendEntry& blend) {
            return !blend.across && edge.isBetween(blend.from, blend.to);
        });
    entry.blends.push_back(std::move(square));
}

using AcrossForm = FieldForm<SamplesEntry, LabelForm>;

void addPair(AcrossForm& fields, CurrentVariation& variation)
{
    const auto history = [] { return AcrossTexts::tr("Vary a blend of four"); };
    fields.addItems(
        {"acrossOf", [] { return AcrossTexts::tr("Across"); },
         [] {
             return AcrossTexts::tr(
                 "The take across from the first: four takes make a square with two weights");
         },
         [&variation](const SamplesEntry& set) {
             return !set.to.empty() && variation.entry()->training.size() >= cornersOfSquare;
         },
         history},
        Lens<SamplesEntry, std::string>{
            [](const SamplesEntry& set) { return acrossOf(set).of; },
            [&variation](SamplesEntry& set, const std::string& take) {
                setAcross(set, take, takeItems(variation, {set.of, set.to, take}));
            }},
        [&variation](const SamplesEntry& set) {
            auto items = takeItems(variation, {set.of, set.to});
            items.insert(items.begin(), {AcrossTexts::tr("nothing: two takes alone"), std::string()});
            return items;
        });
    QComboBox* to = fields.addItems(
        {"acrossTo", [] { return QString(); },
         [] { return AcrossTexts::tr("The take across from the second"); }, hasAcross, history},
        Lens<SamplesEntry, std::string>{
            [](const SamplesEntry& set) { return acrossOf(set).to; },
            [](SamplesEntry& set, std::string take) { set.across->to = std::move(take); }},
        [&variation](const SamplesEntry& set) {
            return takeItems(variation, {set.of, set.to, acrossOf(set).of});
        });
    retranslates(to, [to] { to->setAccessibleName(AcrossTexts::tr("Across from the second take")); });
}

void addPad(AcrossForm& fields, CurrentVariation& variation)
{
    auto* pad = new widgets::WeightsPad;
    QObject::connect(pad, &widgets::WeightsPad::edited, pad,
                     [&variation](const QPointF& weights, bool isFinal) {
                         variation.editSet(
                             AcrossTexts::tr("Change the weights of a blend"), "weights",
                             [&](SamplesEntry& set) {
                                 set.weight = weights.x();
                                 set.across->weight = weights.y();
                             },
                             isFinal ? EditPhase::Final : EditPhase::Dragging);
                     });
    fields.addOther({"acrossPad", [] { return QString(); },
                     [] {
                         return AcrossTexts::tr(
                             "Drag to where variations lie between the four takes; arrows move by 1 %, "
                             "with Shift by 10 %. Dots are blends that are learned.");
                     },
                     hasAcross},
                    pad, [pad, &variation](const SamplesEntry& set) {
                        if (!set.across)
                            return;
                        pad->setCorners({QString::fromStdString(set.of), QString::fromStdString(set.to),
                                         QString::fromStdString(set.across->of),
                                         QString::fromStdString(set.across->to)});
                        pad->setNodes(nodesOf(*variation.entry(), set));
                        pad->setWeights({set.weight, set.across->weight});
                    });
    retranslates(pad, [pad] { pad->setAccessibleName(AcrossTexts::tr("Weights")); });
}

void addLearn(AcrossForm& fields, CurrentVariation& variation)
{
    auto* learn = new QPushButton;
    QObject::connect(learn, &QPushButton::clicked, &variation, [&variation] {
        const SamplesEntry set = *variation.samples();
        variation.edit(AcrossTexts::tr("Learn a square of blends"), QStringLiteral("blends"),
                       [&set](VariationEntry& entry) { learnSquare(entry, set); });
    });
    fields.addOther(
        {"acrossLearn", [] { return QString(); },
         [] {
             return AcrossTexts::tr(
                 "Learn from blends of the four takes, too: on the edges of the square and inside");
         },
         [&variation](const SamplesEntry& set) {
             return set.across && nodesOf(*variation.entry(), set).size() == cornersOfSquare;
         }},
        learn, [](const SamplesEntry& /*set*/) {});
    retranslates(learn, [learn] { learn->setText(AcrossTexts::tr("Learn this square")); });
}

} // namespace

void dropImpossibleAcross(SamplesEntry& samples)
{
    if (!samples.across)
        return;
    const std::set<std::string> corners{samples.of, samples.to, samples.across->of, samples.across->to};
    if (samples.to.empty() || corners.size() < cornersOfSquare)
        samples.across.reset();
}

std::vector<FieldItem<std::string>> takeItems(const CurrentVariation& variation,
                                              const std::set<std::string>& but)
{
    std::vector<FieldItem<std::string>> items;
    if (variation.entry() == nullptr)
        return items;
    for (const TrainingEntry& take : variation.entry()->training) {
        if (!but.contains(take.sequence))
            items.push_back({QString::fromStdString(take.sequence), take.sequence});
    }
    return items;
}

void addAcrossFields(FieldForm<SamplesEntry, LabelForm>& fields, CurrentVariation& variation)
{
    addPair(fields, variation);
    addPad(fields, variation);
    fields.addNumber(
        {"acrossPercent", [] { return AcrossTexts::tr("Upwards"); },
         [] { return AcrossTexts::tr("Weight of the second pair in percent"); }, hasAcross,
         [] { return AcrossTexts::tr("Change the weights of a blend"); }},
        Lens<SamplesEntry, double>{[](const SamplesEntry& set) { return acrossOf(set).weight; },
                                   [](SamplesEntry& set, double weight) { set.across->weight = weight; }},
        {.path = "across_samples.weight", .scale = onePercent, .step = 1, .decimals = 0, .unit = [] {
             return AcrossTexts::tr(" %", "percent");
         }});
    addLearn(fields, variation);
}

} // namespace quadrille

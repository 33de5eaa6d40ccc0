// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/acrossfields.h"

#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "model/core/error.h"
#include "model/project/document/blendedges.h"
#include "model/project/steps/variate.h"
#include "widgets/controls/weightspad.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <set>

namespace quadrille {

namespace {

constexpr double whole = 100; // percent
constexpr double middle = 0.5;

/// Takes that are learned and not among some.
std::vector<std::string> takesBut(const VariationEntry& entry, const std::set<std::string>& some)
{
    std::vector<std::string> takes;
    for (const TrainingEntry& take : entry.training) {
        if (!some.contains(take.sequence))
            takes.push_back(take.sequence);
    }
    return takes;
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

constexpr std::size_t cornersOfSquare = 4;

} // namespace

void dropImpossibleAcross(SamplesEntry& samples)
{
    if (!samples.across)
        return;
    const std::set<std::string> corners{samples.of, samples.to, samples.across->of, samples.across->to};
    if (samples.to.empty() || corners.size() < cornersOfSquare)
        samples.across.reset();
}

AcrossFields::AcrossFields(CurrentVariation& variation, QWidget* parent)
    : QWidget(parent)
    , m_variation(variation)
    , m_of(new QComboBox)
    , m_to(new QComboBox)
    , m_square(new QWidget)
    , m_pad(new widgets::WeightsPad)
    , m_label(new QLabel)
    , m_percent(new QSpinBox)
    , m_learn(new QPushButton)
{
    setObjectName(QStringLiteral("acrossFields"));
    m_of->setObjectName(QStringLiteral("acrossOf"));
    m_to->setObjectName(QStringLiteral("acrossTo"));
    m_pad->setObjectName(QStringLiteral("acrossPad"));
    m_percent->setObjectName(QStringLiteral("acrossPercent"));
    m_learn->setObjectName(QStringLiteral("acrossLearn"));
    for (QComboBox* box : {m_of, m_to}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(6);
    }
    m_percent->setRange(0, static_cast<int>(whole));
    m_percent->setAlignment(Qt::AlignRight);
    m_percent->setKeyboardTracking(false);
    m_label->setBuddy(m_percent);
    auto* percentRow = new QHBoxLayout;
    percentRow->addWidget(m_label);
    percentRow->addWidget(m_percent);
    percentRow->addStretch(1);
    auto* square = new QVBoxLayout(m_square);
    square->setContentsMargins(0, 0, 0, 0);
    square->setSpacing(4);
    square->addWidget(m_to);
    square->addWidget(m_pad);
    square->addLayout(percentRow);
    square->addWidget(m_learn);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_of);
    column->addWidget(m_square);
    connectFields();
    connect(&variation, &CurrentVariation::changed, this, &AcrossFields::refresh);
    retranslates(this, [this] { retranslate(); });
}

void AcrossFields::connectFields()
{
    connect(m_of, &QComboBox::activated, this, &AcrossFields::choose);
    connect(m_to, &QComboBox::textActivated, this, [this](const QString& take) {
        editSet(tr("Vary a blend of four"), "across",
                [&](SamplesEntry& set) { set.across->to = take.toStdString(); });
    });
    connect(m_pad, &widgets::WeightsPad::edited, this, [this](const QPointF& weights, bool isFinal) {
        editSet(
            tr("Change the weights of a blend"), "weights",
            [&](SamplesEntry& set) {
                set.weight = weights.x();
                set.across->weight = weights.y();
            },
            isFinal ? EditPhase::Final : EditPhase::Dragging);
    });
    connect(m_percent, &QSpinBox::valueChanged, this, [this](int percent) {
        editSet(tr("Change the weights of a blend"), "acrossWeight",
                [percent](SamplesEntry& set) { set.across->weight = percent / whole; });
    });
    connect(m_learn, &QPushButton::clicked, this, &AcrossFields::learn);
}

bool AcrossFields::isUseful() const
{
    const SamplesEntry* set = m_variation.samples();
    return set != nullptr && !set->to.empty() && m_variation.entry()->training.size() >= cornersOfSquare;
}

void AcrossFields::retranslate()
{
    m_of->setAccessibleName(tr("Across from the first take"));
    m_of->setToolTip(tr("The take across from the first: four takes make a square with two weights"));
    m_to->setAccessibleName(tr("Across from the second take"));
    m_to->setToolTip(tr("The take across from the second"));
    m_pad->setAccessibleName(tr("Weights"));
    m_pad->setToolTip(
        tr("Drag to where variations lie between the four takes; arrows move by 1 %, with Shift by 10 %. "
           "Dots are blends that are learned."));
    m_label->setText(tr("Upwards"));
    m_percent->setAccessibleName(tr("Weight of the second pair in percent"));
    m_percent->setSuffix(tr(" %", "percent"));
    m_learn->setText(tr("Learn this square"));
    m_learn->setToolTip(
        tr("Learn from blends of the four takes, too: on the edges of the square and inside"));
    refresh();
}

void AcrossFields::refresh()
{
    const QScopedValueRollback showing(m_isShowing, true);
    if (!isUseful())
        return;
    const SamplesEntry& set = *m_variation.samples();
    refreshTakes(set);
    m_square->setVisible(set.across.has_value());
    if (set.across)
        refreshPad(set);
}

void AcrossFields::refreshTakes(const SamplesEntry& set)
{
    const VariationEntry& entry = *m_variation.entry();
    const AcrossSamplesEntry across = set.across.value_or(AcrossSamplesEntry());
    m_of->clear();
    m_to->clear();
    m_of->addItem(tr("nothing: two takes alone"));
    for (const std::string& take : takesBut(entry, {set.of, set.to}))
        m_of->addItem(QString::fromStdString(take));
    for (const std::string& take : takesBut(entry, {set.of, set.to, across.of}))
        m_to->addItem(QString::fromStdString(take));
    m_of->setCurrentIndex(set.across ? m_of->findText(QString::fromStdString(across.of)) : 0);
    m_to->setCurrentIndex(m_to->findText(QString::fromStdString(across.to)));
}

void AcrossFields::refreshPad(const SamplesEntry& set)
{
    std::vector<QPointF> nodes = nodesOf(*m_variation.entry(), set);
    m_learn->setVisible(nodes.size() == cornersOfSquare);
    m_pad->setCorners({QString::fromStdString(set.of), QString::fromStdString(set.to),
                       QString::fromStdString(set.across->of), QString::fromStdString(set.across->to)});
    m_pad->setNodes(std::move(nodes));
    m_pad->setWeights({set.weight, set.across->weight});
    m_percent->setValue(static_cast<int>(std::lround(set.across->weight * whole)));
}

void AcrossFields::choose(int index)
{
    if (index == 0) {
        editSet(tr("Vary a blend of two"), "across", [](SamplesEntry& set) { set.across.reset(); });
        return;
    }
    const std::string take = m_of->currentText().toStdString();
    editSet(tr("Vary a blend of four"), "across", [&](SamplesEntry& set) {
        if (!set.across)
            set.across.emplace().weight = middle;
        set.across->of = take;
        const std::vector<std::string> others = takesBut(*m_variation.entry(), {set.of, set.to, take});
        if (!others.empty() && std::ranges::find(others, set.across->to) == others.end())
            set.across->to = others.front();
    });
}

void AcrossFields::learn()
{
    const SamplesEntry& set = *m_variation.samples();
    BlendEntry square;
    square.from = set.of;
    square.to = set.to;
    square.across.emplace();
    square.across->from = set.across->of;
    square.across->to = set.across->to;
    m_variation.edit(tr("Learn a square of blends"), QStringLiteral("blends"), [&](VariationEntry& entry) {
        // Its edges are learned with it.
        for (const BlendEdge& edge : edgesOf(square))
            std::erase_if(entry.blends, [&](const BlendEntry& blend) {
                return !blend.across && edge.isBetween(blend.from, blend.to);
            });
        entry.blends.push_back(square);
    });
}

void AcrossFields::editSet(const QString& text, const char* property, const Edit& edit, EditPhase phase)
{
    if (m_isShowing || m_variation.samples() == nullptr)
        return;
    m_variation.edit(
        text, QLatin1String(property) + QString::number(m_variation.set()),
        [&](VariationEntry& entry) { edit(entry.samples[static_cast<std::size_t>(m_variation.set())]); },
        phase);
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphsettingspanel.h"

#include "editor/application/editorcontext.h"
#include "editor/commands/animationedits.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr double longestSeconds = 10;

template <typename Value>
void showIn(QComboBox* box, Value value)
{
    const QSignalBlocker blocker(box);
    box->setCurrentIndex(static_cast<int>(value));
}

template <typename Field, typename Value>
void showIn(Field* field, Value value)
{
    const QSignalBlocker blocker(field);
    field->setValue(value);
}

} // namespace

GraphSettingsPanel::GraphSettingsPanel(EditorContext& context, QWidget* parent)
    : PropertyForm(parent)
    , m_context(context)
    , m_metric(new QComboBox)
    , m_stretch(new QDoubleSpinBox)
    , m_cost(new QComboBox)
    , m_scale(new QComboBox)
    , m_length(new QComboBox)
    , m_smoothing(new QComboBox)
    , m_contacts(new QDoubleSpinBox)
    , m_velocity(new QDoubleSpinBox)
    , m_slope(new QSpinBox)
    , m_shortest(new QDoubleSpinBox)
    , m_longest(new QDoubleSpinBox)
    , m_greatest(new QDoubleSpinBox)
    , m_published(new QPushButton)
{
    setObjectName(QStringLiteral("graphSettingsPanel"));
    makeFields();
    connectFields();
    retranslate();
    connect(&context.document, &ProjectDocument::changed, this, &GraphSettingsPanel::refresh);
}

void GraphSettingsPanel::makeFields()
{
    for (QComboBox* box : {m_metric, m_cost, m_scale, m_length}) {
        box->addItems({QString(), QString()});
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    }
    m_smoothing->addItems({QString(), QStringLiteral("3 × 3"), QStringLiteral("5 × 5")});
    m_smoothing->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_stretch->setRange(0, 100);
    m_stretch->setDecimals(3);
    m_stretch->setSingleStep(0.01);
    for (QDoubleSpinBox* field : {m_contacts, m_velocity}) {
        field->setRange(0, 10);
        field->setDecimals(3);
        field->setSingleStep(0.05);
    }
    m_slope->setRange(TransitionSettings::leastSlope, TransitionSettings::greatestSlope);
    for (QDoubleSpinBox* field : {m_shortest, m_longest}) {
        field->setRange(0, longestSeconds); // 0 stands for automatic
        field->setSingleStep(0.1);
    }
    m_greatest->setRange(0, 1e6); // 0 stands for automatic
    m_greatest->setDecimals(4);
    for (QAbstractSpinBox* field : std::initializer_list<QAbstractSpinBox*>{
             m_stretch, m_contacts, m_velocity, m_slope, m_shortest, m_longest, m_greatest}) {
        field->setKeyboardTracking(false);
        field->setAlignment(Qt::AlignRight);
    }
    addField(
        "graphMetric", [] { return tr("Poses"); }, m_metric,
        [] { return tr("How two poses are compared, wherever the body stands"); });
    addField(
        "graphStretch", [] { return tr("Stretch"); }, m_stretch,
        [] { return tr("Weight of the surface's stretch against its rotation, 0 to 100"); });
    addField(
        "graphCost", [] { return tr("Cost"); }, m_cost,
        [] { return tr("Whether a transition's pose distances are summed, as published, or averaged"); });
    addField(
        "graphScale", [] { return tr("Weigh by"); }, m_scale,
        [] { return tr("Whether transitions between calm takes must be better than those of lively ones"); });
    addField(
        "graphLength", [] { return tr("Lasts"); }, m_length,
        [] {
            return tr("How long a transition lasts: while it follows its warp path, as published, its takes "
                      "slow down; as the mean of its windows they keep their pace");
        });
    addField(
        "graphContacts", [] { return tr("Feet"); }, m_contacts,
        [] {
            return tr("What it costs to blend frames of which every foot stands in one only, and as much to "
                      "drag a foot over an eighth of the body’s height; 0 as published");
        });
    addField(
        "graphVelocity", [] { return tr("Speed"); }, m_velocity,
        [] {
            return tr("What it costs when body and feet move otherwise, for a body height a second; 0 as "
                      "published");
        });
    addField(
        "graphSlope", [] { return tr("Slope"); }, m_slope,
        [] { return tr("How many frames in a row one take may wait for the other, 2 to 5"); });
    addField(
        "graphShortest", [] { return tr("Shortest window"); }, m_shortest,
        [] { return tr("Frames of each take that a transition blends at the least, in seconds"); });
    addField(
        "graphLongest", [] { return tr("Longest window"); }, m_longest,
        [] { return tr("Frames of each take that a transition blends at the most, in seconds"); });
    addField(
        "graphSmoothing", [] { return tr("Smoothing"); }, m_smoothing,
        [] {
            return tr("Over how many frames costs are averaged before the minima of the motion graph are "
                      "sought; as published over none");
        });
    addField(
        "graphGreatest", [] { return tr("Largest distance"); }, m_greatest,
        [] { return tr("What costs are divided by; automatic is the largest distance of two poses"); });
    addField(
        "graphPublished", [] { return QString(); }, m_published,
        [] { return tr("Costs and windows as the paper has them, for comparison: transitions show more"); });
}

void GraphSettingsPanel::connectFields()
{
    connect(m_metric, &QComboBox::activated, this, [this](int index) {
        edit(tr("Compare poses otherwise"), QStringLiteral("metric"),
             [index](GraphEntry& entry) { entry.pose.metric = static_cast<PoseMetric>(index); });
    });
    connect(m_stretch, &QDoubleSpinBox::valueChanged, this, [this](double weight) {
        edit(tr("Weigh stretch otherwise"), QStringLiteral("stretch"),
             [weight](GraphEntry& entry) { entry.pose.stretchWeight = weight; });
    });
    connect(m_cost, &QComboBox::activated, this, [this](int index) {
        edit(tr("Change the cost of transitions"), QStringLiteral("cost"),
             [index](GraphEntry& entry) { entry.cost = static_cast<TransitionCost>(index); });
    });
    connect(m_scale, &QComboBox::activated, this, [this](int index) {
        edit(tr("Weigh transitions otherwise"), QStringLiteral("scale"),
             [index](GraphEntry& entry) { entry.costScale = static_cast<CostScale>(index); });
    });
    connect(m_length, &QComboBox::activated, this, [this](int index) {
        edit(tr("Change how long transitions last"), QStringLiteral("length"),
             [index](GraphEntry& entry) { entry.length = static_cast<TransitionLength>(index); });
    });
    connect(m_contacts, &QDoubleSpinBox::valueChanged, this, [this](double weight) {
        edit(tr("Weigh feet otherwise"), QStringLiteral("contacts"),
             [weight](GraphEntry& entry) { entry.steps.contacts = weight; });
    });
    connect(m_velocity, &QDoubleSpinBox::valueChanged, this, [this](double weight) {
        edit(tr("Weigh speed otherwise"), QStringLiteral("velocity"),
             [weight](GraphEntry& entry) { entry.steps.velocity = weight; });
    });
    connect(m_published, &QPushButton::clicked, this, [this] {
        edit(tr("Seek transitions as published"), QStringLiteral("published"), [](GraphEntry& entry) {
            const GraphEntry paper = GraphEntry::paper();
            entry.cost = paper.cost;
            entry.costScale = paper.costScale;
            entry.length = paper.length;
            entry.steps = paper.steps;
            entry.durations = paper.durations;
            entry.smoothing = paper.smoothing;
        });
    });
    connect(m_smoothing, &QComboBox::activated, this, [this](int index) {
        edit(tr("Smooth the costs otherwise"), QStringLiteral("smoothing"),
             [index](GraphEntry& entry) { entry.smoothing = static_cast<CostSmoothing>(index); });
    });
    connect(m_slope, &QSpinBox::valueChanged, this, [this](int slope) {
        edit(tr("Change the slope of transitions"), QStringLiteral("slope"),
             [slope](GraphEntry& entry) { entry.slope = slope; });
    });
    connect(m_shortest, &QDoubleSpinBox::valueChanged, this, &GraphSettingsPanel::editDurations);
    connect(m_longest, &QDoubleSpinBox::valueChanged, this, &GraphSettingsPanel::editDurations);
    connect(m_greatest, &QDoubleSpinBox::valueChanged, this, [this](double distance) {
        edit(tr("Change the largest distance"), QStringLiteral("greatest"), [distance](GraphEntry& entry) {
            entry.greatestDistance = distance > 0 ? std::optional(distance) : std::nullopt;
        });
    });
}

void GraphSettingsPanel::edit(const QString& text, const QString& property,
                              const std::function<void(GraphEntry&)>& change)
{
    GraphEntry entry = graphEntry(m_context.document.project(), m_character);
    if (entry.character.empty())
        entry.character = m_character.toStdString();
    change(entry);
    setGraph(m_context.document, text, property, entry);
}

/// Automatic windows stand in the file as none; where one of both is given, so is the other.
void GraphSettingsPanel::editDurations()
{
    edit(tr("Change the windows of transitions"), QStringLiteral("durations"), [this](GraphEntry& entry) {
        if (m_shortest->value() == 0 && m_longest->value() == 0) {
            entry.durations.reset();
            return;
        }
        const double shortest = m_shortest->value() > 0 ? m_shortest->value() : usualDurations.first;
        const double longest = m_longest->value() > 0 ? m_longest->value() : usualDurations.second;
        entry.durations.emplace(shortest, std::max(shortest, longest));
    });
}

void GraphSettingsPanel::show(const QString& character)
{
    m_character = character;
    refresh();
}

void GraphSettingsPanel::refresh()
{
    const GraphEntry entry = graphEntry(m_context.document.project(), m_character);
    showIn(m_metric, entry.pose.metric);
    showIn(m_stretch, entry.pose.stretchWeight);
    setFieldVisible(m_stretch, entry.pose.metric == PoseMetric::Surface);
    showIn(m_cost, entry.cost);
    showIn(m_scale, entry.costScale);
    showIn(m_length, entry.length);
    showIn(m_smoothing, entry.smoothing);
    showIn(m_contacts, entry.steps.contacts);
    showIn(m_velocity, entry.steps.velocity);
    showIn(m_slope, entry.slope);
    showIn(m_shortest, entry.durations ? entry.durations->first : 0);
    showIn(m_longest, entry.durations ? entry.durations->second : 0);
    showIn(m_greatest, entry.greatestDistance.value_or(0));
    m_greatest->setSuffix(entry.pose.metric == PoseMetric::Surface ? QStringLiteral(" rad")
                                                                   : QStringLiteral(" m"));
    setEnabled(!m_context.graphs.characters().isEmpty());
}

void GraphSettingsPanel::retranslate()
{
    m_metric->setItemText(0, tr("By their surfaces"));
    m_metric->setItemText(1, tr("By their vertices"));
    m_cost->setItemText(0, tr("Sum of the distances"));
    m_cost->setItemText(1, tr("Mean of the distances"));
    m_smoothing->setItemText(0, tr("none", "smoothing"));
    m_scale->setItemText(0, tr("Nothing else"));
    m_scale->setItemText(1, tr("Liveliness of the takes"));
    m_length->setItemText(0, tr("As long as its warp path"));
    m_length->setItemText(1, tr("As long as its windows"));
    //: after a number: steps of a warp path in a row
    m_slope->setSuffix(tr(" frames"));
    for (QDoubleSpinBox* field : {m_shortest, m_longest}) {
        field->setSuffix(tr(" s"));
        field->setSpecialValueText(tr("automatic"));
    }
    for (QDoubleSpinBox* field : {m_contacts, m_velocity})
        field->setSuffix(QStringLiteral(" rad"));
    m_greatest->setSpecialValueText(tr("automatic"));
    m_published->setText(tr("As published"));
    refresh();
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphsettingspanel.h"

#include "editor/commands/animationedits.h"
#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"

#include <QPushButton>
#include <algorithm>

namespace quadrille {

namespace {

constexpr double shortestWindow = 0.05; // seconds that can be entered

/// One of both ends of the windows of transitions. Automatic ones stand in the file as none; where one of
/// both is given, so is the other, and moves where it has to.
Lens<GraphEntry, std::optional<double>> windowEnd(double std::pair<double, double>::*end)
{
    return {[=](const GraphEntry& entry) {
                return entry.durations ? std::optional((*entry.durations).*end) : std::nullopt;
            },
            [=](GraphEntry& entry, std::optional<double> seconds) {
                auto windows = entry.durations.value_or(usualDurations);
                windows.*end = seconds.value_or(usualDurations.*end);
                const bool isFirst = end == &std::pair<double, double>::first;
                (isFirst ? windows.second : windows.first) = isFirst
                                                                 ? std::max(windows.first, windows.second)
                                                                 : std::min(windows.first, windows.second);
                entry.durations =
                    seconds || windows != usualDurations ? std::optional(windows) : std::nullopt;
            }};
}

} // namespace

GraphSettingsPanel::GraphSettingsPanel(EditorContext& context, QWidget* parent)
    : SettingForm(parent)
    , m_context(context)
    , m_fields(*this, [this](const QString& text, const char* property,
                             const auto& change) { edit(text, property, change); })
    , m_published(new QPushButton)
{
    setObjectName(QStringLiteral("graphSettingsPanel"));
    addDistances();
    addCosts();
    addWindows();
    addPublished();
    connect(&context.document, &ProjectDocument::changed, this, &GraphSettingsPanel::refresh);
    retranslates(this, [this] {
        m_fields.retranslate();
        m_published->setText(tr("As published"));
        refresh();
    });
}

void GraphSettingsPanel::addDistances()
{
    addHeading([] { return tr("Distances of poses"); });
    m_fields.addChoice({"graphMetric", [] { return tr("Poses"); },
                        [] { return tr("How two poses are compared, wherever the body stands"); }},
                       at(&GraphEntry::pose, &PoseDistanceSettings::metric),
                       {[] { return tr("By their surfaces"); }, [] { return tr("By their vertices"); }});
    m_fields.addNumber({"graphStretch", [] { return tr("Stretch"); },
                        [] { return tr("Weight of the surface's stretch against its rotation"); },
                        [](const GraphEntry& entry) { return entry.pose.metric == PoseMetric::Surface; }},
                       at(&GraphEntry::pose, &PoseDistanceSettings::stretchWeight),
                       {.path = "graph.stretch_weight", .step = 0.01, .decimals = 3});
    m_fields.addNumber({"graphTriangles", [] { return tr("Triangles"); },
                        [] {
                            return tr("How many triangles, or vertices, poses are compared by, spread "
                                      "evenly over the surface; fewer take less time and are less exact. "
                                      "Automatic: all, or 1,000 where there are more than 5,000 frames");
                        }},
                       at(&GraphEntry::pose, &PoseDistanceSettings::triangles),
                       {.path = "graph.triangles",
                        .step = 500,
                        .decimals = 0,
                        .automatic = [] { return tr("automatic"); },
                        .highest = 1e7,
                        .first = 2000});
    m_greatest = m_fields.addNumber(
        {"graphGreatest", [] { return tr("Largest distance"); },
         [] { return tr("What costs are divided by; automatic is the largest distance of two poses"); }},
        &GraphEntry::greatestDistance,
        {.path = "graph.d_max", .decimals = 4, .automatic = [] { return tr("automatic"); }, .highest = 1e6});
}

void GraphSettingsPanel::addCosts()
{
    addHeading([] { return tr("Costs of transitions"); });
    m_fields.addChoice(
        {"graphCost", [] { return tr("Cost"); },
         [] { return tr("Whether a transition's pose distances are summed, as published, or averaged"); }},
        &GraphEntry::cost,
        {[] { return tr("Sum", "of distances"); }, [] { return tr("Mean", "of distances"); }});
    m_fields.addChoice(
        {"graphScale", [] { return tr("Weigh by"); },
         [] {
             return tr("Whether transitions between calm takes must be better than those of lively ones");
         }},
        &GraphEntry::costScale, {[] { return tr("Nothing else"); }, [] { return tr("Liveliness"); }});
    m_fields.addNumber(
        {"graphContacts", [] { return tr("Feet"); },
         [] {
             return tr("What it costs to blend frames of which every foot stands in one only, and as "
                       "much to drag a foot over an eighth of the body’s height; 0 as published");
         }},
        at(&GraphEntry::steps, &StepWeights::contacts),
        {.path = "graph.contact_weight", .step = 0.05, .decimals = 3, .unit = [] {
             return QStringLiteral(" rad");
         }});
    m_fields.addNumber(
        {"graphVelocity", [] { return tr("Speed"); },
         [] {
             return tr("What it costs when body and feet move otherwise, for a body height a second; "
                       "0 as published");
         }},
        at(&GraphEntry::steps, &StepWeights::velocity),
        {.path = "graph.velocity_weight", .step = 0.05, .decimals = 3, .unit = [] {
             return QStringLiteral(" rad");
         }});
    m_fields.addChoice({"graphSmoothing", [] { return tr("Smoothing"); },
                        [] {
                            return tr("Over how many frames costs are averaged before the minima of the "
                                      "motion graph are sought; as "
                                      "published over none");
                        }},
                       &GraphEntry::smoothing,
                       {[] { return tr("none", "smoothing"); }, [] { return QStringLiteral("3 × 3"); },
                        [] { return QStringLiteral("5 × 5"); }});
}

void GraphSettingsPanel::addWindows()
{
    addHeading([] { return tr("Windows of transitions"); });
    m_fields.addChoice(
        {"graphLength", [] { return tr("As long as"); },
         [] {
             return tr(
                 "How long a transition lasts: while it follows its warp path, as published, its takes slow "
                 "down; as the mean of its windows they keep their pace");
         }},
        &GraphEntry::length, {[] { return tr("Its warp path"); }, [] { return tr("Its windows"); }});
    m_fields.addNumber(
        {"graphSlope", [] { return tr("Slope"); },
         [] { return tr("How many frames in a row one take may wait for the other, 2 to 5"); }},
        &GraphEntry::slope,
        //: after a number: steps of a warp path in a row
        {.path = "graph.slope", .step = 1, .decimals = 0, .unit = [] { return tr(" frames"); }});
    const NumberLook window{.unit = [] { return tr(" s"); },
                            .automatic = [] { return tr("automatic"); },
                            .lowest = shortestWindow,
                            .highest = longestWindow};
    m_fields.addNumber(
        {"graphShortest", [] { return tr("Shortest window"); },
         [] { return tr("Frames of each take that a transition blends at the least, in seconds"); }},
        windowEnd(&std::pair<double, double>::first), window);
    m_fields.addNumber(
        {"graphLongest", [] { return tr("Longest window"); },
         [] { return tr("Frames of each take that a transition blends at the most, in seconds"); }},
        windowEnd(&std::pair<double, double>::second), window);
}

void GraphSettingsPanel::addPublished()
{
    m_fields.addOther(
        {"graphPublished",
         {},
         [] { return tr("Costs and windows as the paper has them, for comparison: transitions show more"); }},
        m_published, [](const GraphEntry&) {}, [](const GraphEntry&) { return true; }, [] {});
    connect(m_published, &QPushButton::clicked, this, [this] {
        edit(tr("Seek transitions as published"), "published", [](GraphEntry& entry) {
            const GraphEntry paper = GraphEntry::paper();
            entry.cost = paper.cost;
            entry.costScale = paper.costScale;
            entry.length = paper.length;
            entry.steps = paper.steps;
            entry.durations = paper.durations;
            entry.smoothing = paper.smoothing;
        });
    });
}

void GraphSettingsPanel::edit(const QString& text, const char* property,
                              const std::function<void(GraphEntry&)>& change)
{
    GraphEntry entry = graphEntry(m_context.document.project(), m_character);
    if (entry.character.empty())
        entry.character = m_character.toStdString();
    change(entry);
    setGraph(m_context.document, text, QLatin1String(property), entry);
}

void GraphSettingsPanel::showCharacter(const QString& character)
{
    m_character = character;
    refresh();
}

void GraphSettingsPanel::refresh()
{
    const GraphEntry entry = graphEntry(m_context.document.project(), m_character);
    m_fields.show(entry);
    m_greatest->setSuffix(entry.pose.metric == PoseMetric::Surface ? QStringLiteral(" rad")
                                                                   : QStringLiteral(" m"));
    setEnabled(!m_context.graphs.characters().isEmpty());
}

} // namespace quadrille

#include "moc_graphsettingspanel.cpp"

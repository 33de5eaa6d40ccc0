// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/transitionpanel.h"

#include "editor/language/retranslate.h"
#include "editor/workspaces/graph/alternativeslist.h"
#include "editor/workspaces/graph/costbar.h"
#include "editor/workspaces/graph/framenames.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "editor/workspaces/graph/graphmap.h"
#include "editor/workspaces/graph/transitionspeeds.h"
#include "model/graph/shortestpath.h"
#include "widgets/graph/chartscale.h"
#include "widgets/theme/theme.h"

#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

namespace quadrille {

namespace {

using widgets::chartNumber;

} // namespace

TransitionPanel::TransitionPanel(GraphExplorer& explorer, TransitionSpeeds& speeds, FramePictures& pictures,
                                 QWidget* parent)
    : QWidget(parent)
    , m_explorer(explorer)
    , m_speeds(speeds)
    , m_title(new QLabel)
    , m_empty(new QLabel)
    , m_content(new QWidget)
    , m_bar(new CostBar)
    , m_heading(new QLabel)
    , m_alternatives(new AlternativesList(explorer, speeds, pictures))
{
    setObjectName(QStringLiteral("transitionPanel"));
    m_title->setObjectName(QStringLiteral("transitionTitle"));
    m_title->setWordWrap(true);
    m_empty->setObjectName(QStringLiteral("transitionEmpty"));
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    QFont heavier = font();
    heavier.setWeight(QFont::DemiBold);
    m_title->setFont(heavier);
    m_heading->setFont(heavier);
    m_heading->setWordWrap(true);
    m_form = new QFormLayout;
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setHorizontalSpacing(12);
    m_form->setVerticalSpacing(4);
    m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    m_weight = addFact("transitionWeight");
    m_deformation = addFact("transitionDeformation");
    m_poseCost = addFact("transitionPoses");
    m_feetCost = addFact("transitionFeet");
    m_speedCost = addFact("transitionSpeeds");
    m_duration = addFact("transitionDuration");
    m_form->addRow(m_bar);
    m_length = addFact("transitionLength");
    m_windows = addFact("transitionWindows");
    m_slide = addFact("transitionSlide");
    m_jump = addFact("transitionJump");
    m_essential = addFact("transitionEssential");
    m_motion = addFact("transitionMotion");
    auto* inner = new QVBoxLayout(m_content);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(8);
    inner->addWidget(m_title);
    inner->addLayout(m_form);
    inner->addSpacing(4);
    inner->addWidget(m_heading);
    inner->addWidget(m_alternatives, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 12);
    column->addWidget(m_content);
    column->addWidget(m_empty, 1);
    connect(&explorer, &GraphExplorer::characterChanged, this, [this] { show(std::nullopt); });
    connect(&explorer, &GraphExplorer::graphsChanged, this, &TransitionPanel::refresh);
    connect(m_alternatives, &AlternativesList::chosen, this, &TransitionPanel::chosen);
    connect(&speeds, &TransitionSpeeds::changed, this, &TransitionPanel::showSpeeds);
    retranslates(this, [this] { retranslate(); });
}

QLabel* TransitionPanel::addFact(const char* objectName)
{
    auto* name = new QLabel;
    auto* value = new QLabel;
    value->setObjectName(QLatin1String(objectName));
    value->setFont(widgets::Theme::tabularFont(value->font()));
    value->setWordWrap(true);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_form->addRow(name, value);
    m_facts.push_back({name, value});
    return value;
}

void TransitionPanel::setFps(double fps)
{
    m_fps = fps;
    refresh();
}

void TransitionPanel::show(const std::optional<FramePair>& pair)
{
    m_pair = pair;
    refresh();
    m_alternatives->show(pair);
    showHeading();
}

std::optional<FramePair> TransitionPanel::listBest(int from, int to)
{
    m_alternatives->showBest(from, to);
    showHeading();
    const auto& listed = m_alternatives->listed();
    return listed.empty() ? std::nullopt : std::optional(listed.front());
}

void TransitionPanel::showHeading()
{
    const auto& ends = m_alternatives->ends();
    const auto nameOf = [this](int take) {
        return QString::fromStdString(
            m_explorer.character()->graph.work().sequences[static_cast<std::size_t>(take)]);
    };
    //: two takes
    m_heading->setText(ends ? tr("Best from “%1” to “%2”").arg(nameOf(ends->first), nameOf(ends->second))
                            : tr("Next best from about there"));
    m_alternatives->setAccessibleName(m_heading->text());
}

void TransitionPanel::refresh()
{
    const bool isShown = m_pair && m_explorer.character();
    m_content->setVisible(isShown);
    m_empty->setVisible(!isShown);
    if (!isShown)
        return;
    m_title->setText(pairName(m_explorer, *m_pair));
    showCost();
    showMembership();
    showSpeeds();
}

void TransitionPanel::showCost()
{
    const CharacterGraph& graph = m_explorer.character()->graph;
    const TransitionCosts& costs = graph.costs();
    const auto [i, j] = *m_pair;
    const QString none = QStringLiteral("–");
    if (!costs.hasTransition(i, j)) {
        for (QLabel* label :
             {m_deformation, m_poseCost, m_feetCost, m_speedCost, m_duration, m_length, m_windows})
            label->setText(none);
        m_weight->setText(i == j ? tr("a frame is no transition to itself")
                                 : tr("none: no windows fit between these frames"));
        m_bar->setParts({}, 0);
        return;
    }
    const double alpha = m_explorer.alpha();
    const double deformation = costs.weight(i, j, 0);
    const int length = costs.length()(i, j);
    m_weight->setText(chartNumber(costs.weight(i, j, alpha)));
    const QString cost = chartNumber(costs.cost()(i, j));
    const QString greatest = chartNumber(costs.cost()(i, j) / (deformation > 0 ? deformation : 1));
    m_deformation->setText(
        deformation > 0
            //: a weight, then the cost and the largest distance that it is divided by
            ? tr("%1 = %2 / %3 %4").arg(chartNumber(deformation), cost, greatest, costUnit(m_explorer))
            : chartNumber(0));
    //: a weight, then α times a number of frames
    m_duration->setText(
        tr("%1 = %2 × %3").arg(chartNumber(alpha * length), chartNumber(alpha), QLocale().toString(length)));
    m_length->setText(
        tr("%n frame(s), %1 s", nullptr, length).arg(QLocale().toString((length - 1) / m_fps, 'f', 2)));
    const auto transition = graph.transition(*m_pair);
    //: frames of the source window and of the destination window
    m_windows->setText(
        transition ? tr("%1 and %2 frames").arg(transition->sourceWindow).arg(transition->destinationWindow)
                   : QString());
    const CostParts parts = graph.partsOf(*m_pair);
    const double sum = parts.sum();
    const auto part = [&](double value) {
        //: a cost, its unit, and its share
        return tr("%1 %2, %3 %")
            .arg(chartNumber(value), costUnit(m_explorer),
                 QLocale().toString(sum > 0 ? 100 * value / sum : 0, 'f', 0));
    };
    m_poseCost->setText(part(parts.pose));
    m_feetCost->setText(part(parts.contacts));
    m_speedCost->setText(part(parts.velocity));
    const double scale = sum > 0 ? deformation / sum : 0;
    m_bar->setParts({parts.pose * scale, parts.contacts * scale, parts.velocity * scale}, alpha * length);
}

QString TransitionPanel::replacement() const
{
    const CharacterGraph& graph = m_explorer.character()->graph;
    const auto path = shortestPath(m_explorer.graphs()->essential, m_pair->source, m_pair->destination);
    if (!path || path->edges.empty())
        return tr("No way leads there.");
    QStringList stops;
    NodeIndex start = path->edges.front().from;
    const auto stretch = [&](NodeIndex first, NodeIndex last) {
        return first == last
                   ? frameName(m_explorer, first)
                   //: frames of a sequence in a row: the first with the sequence, the last alone
                   : tr("%1–%2").arg(frameName(m_explorer, first), QLocale().toString(static_cast<qlonglong>(
                                                                       graph.nameOf(last).frame.value)));
    };
    for (const Edge& edge : path->edges) {
        if (edge.kind != EdgeKind::Transition)
            continue;
        stops += stretch(start, edge.from);
        start = edge.to;
    }
    stops += stretch(start, path->edges.back().to);
    //: the cost of a way and the frames that it goes through
    return tr("A way that costs %1: %2").arg(chartNumber(path->cost), stops.join(QStringLiteral(" → ")));
}

void TransitionPanel::showMembership()
{
    const auto& graphs = m_explorer.graphs();
    if (!graphs) {
        m_essential->setText(QStringLiteral("…"));
        m_motion->setText(QStringLiteral("…"));
        return;
    }
    const auto textOf = [&](const Digraph& graph) {
        const Edge* edge = graph.find(m_pair->source, m_pair->destination);
        if (edge == nullptr)
            return QString();
        return edge->kind == EdgeKind::Original ? tr("Yes: one plays on to the other as captured")
                                                : tr("Yes");
    };
    const QString essential = textOf(graphs->essential);
    const QString motion = textOf(graphs->motion);
    if (!essential.isEmpty())
        m_essential->setText(essential);
    else
        m_essential->setText(graphs->isWhole ? tr("No. %1").arg(replacement()) : QStringLiteral("…"));
    m_motion->setText(motion.isEmpty() ? tr("No: not a local minimum of the cost") : motion);
}

void TransitionPanel::showSpeeds()
{
    if (!m_pair || !m_explorer.character())
        return;
    const auto [i, j] = *m_pair;
    const bool isTransition = m_explorer.character()->graph.costs().hasTransition(i, j);
    const TransitionSpeeds::Speeds* speeds = isTransition ? m_speeds.of(*m_pair) : nullptr;
    const auto text = [&](std::optional<double> TransitionSpeeds::Speeds::*speed) {
        const bool isMeasured = speeds != nullptr || !isTransition;
        const auto value = speeds != nullptr ? speeds->*speed : std::nullopt;
        const QString number = speedText(isMeasured, value);
        //: a speed
        return value ? tr("%1 m/s").arg(number) : number;
    };
    m_slide->setText(text(&TransitionSpeeds::Speeds::slide));
    m_jump->setText(text(&TransitionSpeeds::Speeds::jump));
}

void TransitionPanel::retranslate()
{
    m_empty->setText(tr("Click a cell of the map to see what the transition costs and why."));
    const std::vector<std::pair<QString, QString>> names{
        {tr("Weight"), tr("Deformation and duration together")},
        {tr("Deformation"), tr("Cost of the warp path over the largest pose distance")},
        {tr("of which poses"), tr("How far the poses are from each other that are blended")},
        {tr("of which feet"),
         tr("What blended frames cost in which other feet stand (Feet, under Settings)")},
        {tr("of which speeds"),
         tr("What blended frames cost in which body and feet move otherwise (Speed, under Settings)")},
        {tr("Duration"), tr("α for each frame that the transition lasts")},
        {tr("Lasts"), tr("From the last captured pose to the next")},
        {tr("Windows"), tr("How many frames of both takes are blended")},
        {tr("Foot slide"), tr("How fast the feet that stand in both takes slide, on average")},
        {tr("Speed jump"),
         tr("How much the body’s velocity over the ground changes, from the frames before the "
            "transition to those behind it")},
        {tr("Essential graph"), tr("It holds what no cheaper way can replace")},
        {tr("Motion graph"), tr("It holds the local minima of the cost")}};
    for (std::size_t i = 0; i < names.size(); ++i) {
        m_facts[i].name->setText(names[i].first);
        m_facts[i].name->setToolTip(names[i].second);
        m_facts[i].value->setAccessibleName(names[i].first);
    }
    show(m_pair);
}

} // namespace quadrille

#include "moc_transitionpanel.cpp"

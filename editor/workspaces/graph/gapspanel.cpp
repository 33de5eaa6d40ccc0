// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/gapspanel.h"

#include "editor/fields/rightmenu.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/graph/framenames.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "editor/workspaces/graph/graphmap.h"
#include "widgets/graph/chartscale.h"

#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>

namespace quadrille {

namespace {

using widgets::chartNumber;

constexpr int pairRole = Qt::UserRole;
constexpr int isTransitionRole = Qt::UserRole + 1;

/// Breaks lines where the panel ends: Qt's own views paint them broken, but keep the room of one.
class BrokenLines : public QStyledItemDelegate
{
public:
    explicit BrokenLines(QTreeView* view) : QStyledItemDelegate(view), m_view(view)
    {
        QObject::connect(view->header(), &QHeaderView::sectionResized, this,
                         [this] { emit sizeHintChanged({}); });
    }
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        int depth = 1;
        for (QModelIndex parent = index.parent(); parent.isValid(); parent = parent.parent())
            ++depth;
        const int margin = m_view->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, m_view) + 1;
        const int width = m_view->columnWidth(0) - depth * m_view->indentation() - 2 * margin;
        const QRect text = option.fontMetrics.boundingRect(0, 0, std::max(width, 40), 10'000,
                                                           Qt::TextWordWrap, index.data().toString());
        return {text.width(), text.height() + 4};
    }

private:
    QTreeView* m_view;
};

} // namespace

GapsPanel::GapsPanel(GraphExplorer& explorer, QWidget* parent)
    : QWidget(parent), m_explorer(explorer), m_summary(new QLabel), m_tree(new QTreeWidget)
{
    setObjectName(QStringLiteral("gapsPanel"));
    m_summary->setObjectName(QStringLiteral("gapsSummary"));
    m_summary->setWordWrap(true);
    m_summary->setForegroundRole(QPalette::PlaceholderText);
    m_tree->setObjectName(QStringLiteral("gapsTree"));
    addRightMenu(*m_tree);
    m_tree->setHeaderHidden(true);
    m_tree->setWordWrap(true);
    m_tree->setTextElideMode(Qt::ElideRight);
    m_tree->setIndentation(8);
    m_tree->setItemDelegate(new BrokenLines(m_tree));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    column->addWidget(m_summary);
    column->addWidget(m_tree, 1);
    connect(m_tree, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) { choose(item); });
    connect(m_tree, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) { choose(item); });
    connect(&explorer, &GraphExplorer::characterChanged, this, &GapsPanel::refresh);
    connect(&explorer, &GraphExplorer::gapsChanged, this, &GapsPanel::refresh);
    connect(&explorer, &GraphExplorer::filterChanged, this, &GapsPanel::refresh);
    retranslates(this, [this] { refresh(); });
}

void GapsPanel::choose(QTreeWidgetItem* item)
{
    const QVariant pair = item->data(0, pairRole);
    if (pair.isValid())
        emit chosen(pair.value<FramePair>(), item->data(0, isTransitionRole).toBool());
}

void GapsPanel::refresh()
{
    m_tree->clear();
    m_tree->setAccessibleName(tr("Gaps of the graphs"));
    const auto& gaps = m_explorer.gaps();
    const auto& measured = m_explorer.measured();
    m_summary->setText(gaps ? tr("Frames that walks do not reach, or do not come back from, and what "
                                 "would help. A click shows it.")
                            : tr("Compute the graph to see which frames walks cannot reach."));
    if (!gaps || !measured)
        return;
    addGraph(tr("Essential graph"), measured->essential.connectivity, gaps->essential);
    addGraph(tr("Motion graph"), measured->motion.connectivity, gaps->motion);
}

void GapsPanel::addGraph(const QString& name, const Connectivity& connectivity,
                         const std::vector<GraphGap>& gaps)
{
    const auto largest = connectivity.components.empty() ? 0 : connectivity.components.front().size();
    const auto all = static_cast<int>(m_explorer.character()->graph.layout().frameCount());
    //: frames in the largest component, of all frames
    const QString joined = gaps.empty() ? tr("every frame is reached from every other")
                                        : tr("%1 of %2 frames are joined both ways")
                                              .arg(QLocale().toString(static_cast<qulonglong>(largest)),
                                                   QLocale().toString(all));
    //: name of a graph; what it joins
    auto* top = new QTreeWidgetItem(m_tree, {tr("%1: %2").arg(name, joined)});
    auto usual = std::make_unique<QTreeWidgetItem>();
    const FrameLayout& layout = m_explorer.character()->graph.layout();
    for (const GraphGap& gap : gaps) {
        if (!m_explorer.filter().has(layout.sequenceOf(gap.first)))
            continue;
        if (isUsual(gap))
            addGap(*usual, gap, tr("Usual: transitions need these frames"));
        else
            addGap(*top, gap, proposalOf(gap));
    }
    usual->setText(0, tr("Starts and ends of takes: %n", nullptr, usual->childCount()));
    if (usual->childCount() > 0)
        top->addChild(usual.release());
    top->setExpanded(true);
}

bool GapsPanel::isUsual(const GraphGap& gap) const
{
    const CharacterGraph& graph = m_explorer.character()->graph;
    const FrameLayout& layout = graph.layout();
    const int sequence = layout.sequenceOf(gap.first);
    const TransitionSettings settings =
        transitionSettings(graph.work().graph, graph.work().opener->project().settings.fps);
    const bool isAtEnd = gap.kind == GraphGap::Kind::DeadEnd ? gap.last == layout.lastOf(sequence)
                                                             : gap.first == layout.firstOf(sequence);
    return isAtEnd && gap.frameCount() < settings.shortest();
}

void GapsPanel::addGap(QTreeWidgetItem& parent, const GraphGap& gap, const QString& help)
{
    auto* item = new QTreeWidgetItem(&parent, {framesOf(gap) + u'\n' + help});
    const QString reason = gap.kind == GraphGap::Kind::DeadEnd
                               ? tr("No walk leads from there to the largest part of the graph")
                               : tr("No walk leads there from the largest part of the graph");
    item->setToolTip(0, reason + u'\n' + help);
    const auto pair = gap.transition ? gap.transition : gap.take;
    if (!pair)
        return;
    item->setData(0, pairRole, QVariant::fromValue(*pair));
    item->setData(0, isTransitionRole, gap.transition.has_value());
}

QString GapsPanel::framesOf(const GraphGap& gap) const
{
    const NamedFrame last = m_explorer.character()->graph.nameOf(gap.last);
    const QString frames =
        gap.first == gap.last ? frameName(m_explorer, gap.first)
                              : tr("%1–%2").arg(frameName(m_explorer, gap.first),
                                                QLocale().toString(static_cast<qlonglong>(last.frame.value)));
    return gap.kind == GraphGap::Kind::DeadEnd
               //: frames from which no walk comes back
               ? tr("%1: dead end").arg(frames)
               //: frames that no walk reaches
               : tr("%1: not reached").arg(frames);
}

QString GapsPanel::proposalOf(const GraphGap& gap) const
{
    if (gap.transition)
        //: two frames and a weight
        return tr("Take the transition %1 → %2 (weight %3)")
            .arg(frameName(m_explorer, gap.transition->source),
                 frameName(m_explorer, gap.transition->destination), chartNumber(gap.weight));
    if (gap.take)
        //: two frames, and the distance of their poses with its unit
        return tr("Capture a take %1 → %2 (poses %3 %4 apart)")
            .arg(frameName(m_explorer, gap.take->source), frameName(m_explorer, gap.take->destination),
                 chartNumber(gap.distance), costUnit(m_explorer));
    return tr("Capture more takes");
}

} // namespace quadrille

#include "moc_gapspanel.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/live/rewindpanel.h"

#include "editor/language/retranslate.h"
#include "editor/workspaces/live/livesession.h"
#include "widgets/theme/theme.h"

#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace quadrille {

namespace {

enum RewindColumn
{
    WhenColumn,
    WhatColumn,
    LatencyColumn,
    UnlikeColumn,
    WaitingColumn,
    CostColumn,
    RewindColumnCount
};

QString rounded(double value, int digits)
{
    return QLocale().toString(value, 'f', digits);
}

} // namespace

RewindPanel::RewindPanel(LiveSession& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_tree(new QTreeWidget), m_hint(new QLabel)
{
    setObjectName(QStringLiteral("rewindPanel"));
    m_tree->setObjectName(QStringLiteral("rewindTree"));
    m_tree->setColumnCount(RewindColumnCount);
    m_tree->setUniformRowHeights(true);
    m_tree->setFont(widgets::Theme::tabularFont(m_tree->font()));
    m_tree->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    // A click on the end of a long row would move its beginning out of sight.
    m_tree->setAutoScroll(false);
    m_hint->setWordWrap(true);
    m_hint->setContentsMargins(8, 8, 8, 8);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_hint);
    column->addWidget(m_tree, 1);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item == nullptr)
            return;
        QScrollBar& sideways = *m_tree->horizontalScrollBar();
        const int left = sideways.value();
        m_tree->scrollToItem(item);
        sideways.setValue(left);
        m_session.goTo(item->data(WhenColumn, Qt::UserRole).toLongLong());
    });
    connect(&m_session, &LiveSession::decided, this, &RewindPanel::refresh);
    retranslates(this, [this] { retranslate(); });
}

void RewindPanel::retranslate()
{
    m_tree->setAccessibleName(tr("Transitions that were made"));
    m_tree->setHeaderLabels(
        {tr("When"), tr("Transition"), tr("Latency"), tr("Unlikeness"), tr("Waiting"), tr("Cost")});
    m_tree->headerItem()->setToolTip(
        LatencyColumn, tr("From the wish until the target is where it is wanted; of a single way "
                          "from when it was looked for"));
    m_tree->headerItem()->setToolTip(UnlikeColumn, tr("Dissimilarity of the poses that meet, 0 to 1000"));
    m_tree->headerItem()->setToolTip(WaitingColumn, tr("What the latency costs"));
    m_hint->setText(tr("Transitions show here as they are made. Choose one to go back to it: Space "
                       "plays on as it was, and steering takes over from there."));
    refresh();
}

void RewindPanel::refresh()
{
    const QSignalBlocker blocker(m_tree);
    const auto& decisions = m_session.decisions();
    m_hint->setVisible(decisions.empty());
    m_tree->setVisible(!decisions.empty());
    if (decisions.empty()) {
        m_tree->clear();
        return;
    }
    const double fps = m_session.graph()->graph->fps;
    const auto fill = [](QTreeWidgetItem* item, const TransitionChoice& choice, double seconds) {
        item->setText(LatencyColumn, tr("%1 s").arg(rounded(seconds, 2)));
        item->setText(UnlikeColumn, rounded(choice.dissimilarity, 0));
        item->setText(WaitingColumn, rounded(choice.latencyCost, 0));
        item->setText(CostColumn, rounded(choice.cost(), 0));
        for (int c = LatencyColumn; c < RewindColumnCount; ++c)
            item->setTextAlignment(c, Qt::AlignTrailing | Qt::AlignVCenter);
    };
    // Only the end of it changes, but where one went back.
    int kept = 0;
    while (kept < m_tree->topLevelItemCount() && kept < static_cast<int>(decisions.size()) &&
           m_tree->topLevelItem(kept)->data(WhenColumn, Qt::UserRole).toLongLong() ==
               decisions[static_cast<std::size_t>(kept)].tick)
        ++kept;
    while (m_tree->topLevelItemCount() > kept)
        delete m_tree->takeTopLevelItem(kept);
    if (kept < static_cast<int>(decisions.size()))
        m_tree->horizontalScrollBar()->setValue(0); // what is new shows from its beginning
    for (auto d = static_cast<std::size_t>(kept); d < decisions.size(); ++d) {
        const LiveDecision& decision = decisions[d];
        auto* item = new QTreeWidgetItem(m_tree);
        const double when = static_cast<double>(decision.tick) * m_session.tickSeconds();
        item->setText(WhenColumn, tr("%1 s").arg(rounded(when, 2)));
        item->setData(WhenColumn, Qt::UserRole, static_cast<qlonglong>(decision.tick));
        item->setText(WhatColumn,
                      tr("%1 → %2").arg(QString::fromStdString(m_session.graph()->spaces[decision.source]),
                                        QString::fromStdString(m_session.graph()->spaces[decision.target])));
        fill(item, decision.choices[0], m_session.latencyOf(decision));
        const TransitionChoice* goingOn = decision.goingOn();
        for (std::size_t c = 0; c < decision.count; ++c) {
            const TransitionChoice& choice = decision.choices.at(c);
            auto* child = new QTreeWidgetItem(item);
            child->setData(WhenColumn, Qt::UserRole, static_cast<qlonglong>(decision.tick));
            QString text = tr("leave frame %1, enter %2").arg(choice.leavingFrame).arg(choice.arrivalFrame);
            if (c == 0)
                text = tr("%1 (chosen)").arg(text);
            else if (&choice == goingOn)
                text = tr("%1 (going on)").arg(text);
            child->setText(WhatColumn, text);
            fill(child, choice, (choice.sourceFrames + choice.targetFrames) / fps);
        }
    }
}

} // namespace quadrille

#include "moc_rewindpanel.cpp"

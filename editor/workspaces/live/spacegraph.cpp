// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/live/spacegraph.h"

#include "editor/commands/motionspaceedits.h"
#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/live/livesession.h"
#include "widgets/theme/theme.h"
#include "widgets/timeline/draggedframes.h"

#include <QContextMenuEvent>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMenu>
#include <algorithm>
#include <map>
#include <utility>

namespace quadrille {

SpaceGraph::SpaceGraph(EditorContext& context, LiveSession& session, Picture picture, QWidget* parent)
    : TakeGraphView(parent), m_context(context), m_session(session), m_picture(std::move(picture))
{
    setObjectName(QStringLiteral("spaceGraph"));
    setAcceptDrops(true);
    connect(this, &TakeGraphView::chosenByUser, this, [this](const std::vector<int>& nodes) {
        if (!nodes.empty())
            m_session.want(nodes.back());
        refresh();
    });
    connect(this, &TakeGraphView::menuRequested, this, &SpaceGraph::showMenu);
    connect(&m_session, &LiveSession::changed, this, &SpaceGraph::refresh);
    connect(&m_session, &LiveSession::decided, this, &SpaceGraph::refresh);
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &SpaceGraph::refresh);
    retranslates(this, [this] { retranslate(); });
}

void SpaceGraph::retranslate()
{
    setEmptyText(tr("Motion spaces show here. Drop the cards of some takes here to make one of them."));
    setAccessibleName(tr("Motion spaces"));
    refresh();
}

void SpaceGraph::refresh()
{
    std::vector<widgets::TakeNode> nodes;
    std::vector<widgets::TakeLink> links;
    if (m_session.isReady()) {
        std::map<std::pair<int, int>, int> made;
        for (const LiveDecision& each : m_session.decisions())
            ++made[{static_cast<int>(each.source), static_cast<int>(each.target)}];
        int number = 0;
        for (const std::string& space : m_session.graph()->spaces)
            nodes.push_back({QString::fromStdString(space), widgets::Theme::categorical(number++), {}});
        for (const auto& [ends, count] : made)
            links.push_back({ends.first, ends.second, count});
    }
    setNodes(std::move(nodes));
    setLinks(tr("Transitions that were made"), std::move(links));
    showPictures();
    setChosen(m_session.isReady() ? std::vector{m_session.wantedSpace()} : std::vector<int>());
}

void SpaceGraph::showPictures()
{
    std::vector<QImage> pictures;
    if (m_session.isReady()) {
        for (const std::string& space : m_session.graph()->spaces)
            pictures.push_back(m_picture(QString::fromStdString(space)));
    }
    setPictures(pictures);
}

/// Space plays and pauses here, too; Return chooses.
bool SpaceGraph::event(QEvent* event)
{
    const bool plays =
        event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space;
    return !plays && TakeGraphView::event(event);
}

void SpaceGraph::dragEnterEvent(QDragEnterEvent* event)
{
    if (!widgets::draggedTakes(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void SpaceGraph::dragMoveEvent(QDragMoveEvent* event)
{
    event->acceptProposedAction();
    const int space = nodeAt(event->position());
    if (space >= 0 && !canTake(m_context.document, nameOf(space), widgets::draggedTakes(*event->mimeData())))
        event->ignore();
}

void SpaceGraph::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    const QStringList takes = widgets::draggedTakes(*event->mimeData());
    const int space = nodeAt(event->position());
    if (space < 0) {
        m_context.selection.select(
            {Section::MotionSpaces, addMotionSpace(m_context.document, tr("motion space"), takes)});
    } else if (canTake(m_context.document, nameOf(space), takes)) {
        select(space);
        addTakes(m_context.document, m_context.selection.current().name, takes);
    }
    m_context.actions.action(QStringLiteral("edit.properties"))->trigger();
}

void SpaceGraph::contextMenuEvent(QContextMenuEvent* event)
{
    const bool isBeside =
        event->reason() != QContextMenuEvent::Keyboard && nodeAt(event->pos()) < 0 && !linkAt(event->pos());
    if (isBeside)
        showMenu(-1, -1, event->globalPos());
    else
        TakeGraphView::contextMenuEvent(event);
}

void SpaceGraph::select(int space)
{
    m_context.selection.select({Section::MotionSpaces, nameOf(space)});
}

QString SpaceGraph::nameOf(int space) const
{
    return QString::fromStdString(m_session.graph()->spaces[static_cast<std::size_t>(space)]);
}

void SpaceGraph::showMenu(int from, int to, const QPoint& place)
{
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("spaceMenu"));
    if (from != to) {
        menu.addAction(tr("Go to the last of them"), this, [=, this] { goToLast(from, to); });
    } else {
        if (from >= 0) {
            select(from);
            for (const char* id : {"edit.properties", "edit.rename", "edit.duplicate", "edit.remove"})
                menu.addAction(m_context.actions.action(QLatin1String(id)));
            menu.addSeparator();
        }
        menu.addAction(m_context.actions.action(QStringLiteral("motionSpaces.new")));
    }
    menu.exec(place);
}

void SpaceGraph::goToLast(int from, int to)
{
    const auto& decisions = m_session.decisions();
    const auto last = std::ranges::find_if(decisions.rbegin(), decisions.rend(), [&](const auto& each) {
        return static_cast<int>(each.source) == from && static_cast<int>(each.target) == to;
    });
    if (last != decisions.rend())
        m_session.goTo(last->tick);
}

} // namespace quadrille

#include "moc_spacegraph.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What can be done with the cell of the matrix under the pointer, and which takes are looked at.
#include "editor/commands/animationedits.h"
#include "editor/context/editorcontext.h"
#include "editor/workspaces/animate/junctions.h"
#include "editor/workspaces/graph/framenames.h"
#include "editor/workspaces/graph/graphbar.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "editor/workspaces/graph/graphmap.h"
#include "editor/workspaces/graph/graphworkspace.h"
#include "editor/workspaces/graph/transitionpanel.h"
#include "model/project/document/findentry.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <QTabWidget>
#include <algorithm>

namespace quadrille {

void GraphWorkspace::makeMenuActions()
{
    m_context.actions.add({"graph.copyFrames",
                           [] { return tr("Graph"); },
                           [] { return tr("Cop&y the frames"); },
                           [] { return tr("Puts the names of both frames onto the clipboard"); },
                           "copy",
                           {}},
                          [this] { copyFrames(); });
}

void GraphWorkspace::copyFrames()
{
    if (m_chosen && m_explorer->character())
        QGuiApplication::clipboard()->setText(pairName(*m_explorer, *m_chosen));
}

/// What is selected while one looks at the graph is what one wants to see of it.
void GraphWorkspace::followSelection()
{
    if (!m_isActive || !m_explorer->character())
        return;
    const QStringList selected = m_context.selection.current().section == Section::Sequences
                                     ? m_context.selection.sequences()
                                     : QStringList();
    const std::vector<std::string>& takes = m_explorer->character()->graph.work().sequences;
    TakeFilter filter;
    for (std::size_t take = 0; take < takes.size(); ++take) {
        if (selected.contains(QString::fromStdString(takes[take])))
            filter.takes.push_back(static_cast<int>(take));
    }
    m_explorer->setFilter(std::move(filter));
}

void GraphWorkspace::askWhatToDo(const FramePair& pair, const QPoint& globalPosition)
{
    const CharacterGraph& graph = m_explorer->character()->graph;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setObjectName(QStringLiteral("graphCellMenu"));
    for (const char* id : {"graph.play", "graph.frames", "graph.copyFrames"})
        menu->addAction(m_context.actions.action(QLatin1String(id)));
    menu->addSeparator();
    const int from = graph.layout().sequenceOf(pair.source);
    const int to = graph.layout().sequenceOf(pair.destination);
    addTakes(*menu, from, to);
    addBan(*menu, pair);
    menu->addSeparator();
    menu->addAction(m_context.actions.action(QStringLiteral("graph.saveTables")));
    menu->popup(globalPosition);
}

void GraphWorkspace::askAboutTakes(int from, int to, const QPoint& globalPosition)
{
    if (!m_explorer->character())
        return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setObjectName(QStringLiteral("takesMenu"));
    addTakes(*menu, from, to);
    menu->addSeparator();
    menu->addAction(m_context.actions.action(QStringLiteral("graph.saveTables")));
    menu->popup(globalPosition);
}

/// What can be done with one take, or with two.
void GraphWorkspace::addTakes(QMenu& menu, int from, int to)
{
    const std::vector<std::string>& takes = m_explorer->character()->graph.work().sequences;
    const auto nameOf = [&](int take) {
        return QString::fromStdString(takes[static_cast<std::size_t>(take)]);
    };
    //: two takes
    menu.addAction(tr("&List the best transitions from “%1” to “%2”").arg(nameOf(from), nameOf(to)), this,
                   [this, from, to] { listBest(from, to); })
        ->setObjectName(QStringLiteral("listBest"));
    menu.addAction(from == to ? tr("&Only this take") : tr("&Only these takes"), this, [this, from, to] {
        m_explorer->setFilter(
            {from == to ? std::vector{from} : std::vector{std::min(from, to), std::max(from, to)}});
    });
    menu.addAction(tr("&All takes"), this, [this] { m_explorer->setFilter({}); })
        ->setEnabled(!m_explorer->filter().isEmpty());
}

/// Lists them beside the best one.
void GraphWorkspace::listBest(int from, int to)
{
    if (const auto best = m_transition->listBest(from, to)) {
        m_tabs->setCurrentIndex(0);
        m_map->setCurrent(*best);
        activate(*best);
    }
}

/// Banned are transitions of animations: of the one that was worked on last.
void GraphWorkspace::addBan(QMenu& menu, const FramePair& pair)
{
    const QString name = m_context.selection.shownAnimation();
    const AnimationEntry* animation = m_context.document.animation(name);
    const CharacterGraph& graph = m_explorer->character()->graph;
    if (animation == nullptr ||
        characterNameOf(m_context.document.project(), *animation) != m_bar->character().toStdString())
        return;
    const JunctionEntry junction{graph.nameOf(pair.source), graph.nameOf(pair.destination)};
    const bool isBanned = contains(animation->junctions.banned, junction);
    //: an animation
    QAction* action = menu.addAction(tr("&Ban it in “%1”").arg(name));
    action->setObjectName(QStringLiteral("banInAnimation"));
    action->setCheckable(true);
    action->setChecked(isBanned);
    action->setEnabled(graph.costs().hasTransition(pair.source, pair.destination));
    connect(action, &QAction::triggered, this, [this, name, junction, isBanned] {
        AnimationEntry after = *m_context.document.animation(name);
        if (isBanned)
            forget(after.junctions, junction);
        else
            ban(after.junctions, junction);
        setAnimation(m_context.document, name, isBanned ? tr("Allow a transition") : tr("Ban a transition"),
                     QStringLiteral("junctions"), std::move(after));
    });
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What can be done in the workspace.
#include "editor/commands/liveedits.h"
#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/workspaces/live/livesession.h"
#include "editor/workspaces/live/liveworkspace.h"
#include "model/project/document/findentry.h"

#include <QAction>

namespace quadrille {

void LiveWorkspace::makeActions()
{
    const auto group = [] { return tr("Live"); };
    ActionRegistry& actions = m_context.actions;
    actions.add({"live.run",
                 group,
                 [] { return tr("&Play live, or pause"); },
                 [] { return tr("Plays the motion spaces as they are steered, or pauses"); },
                 "play",
                 {}},
                [this] { toggle(); });
    QAction* record = actions.addToggle(
        {"live.record",
         group,
         [] { return tr("&Record"); },
         [] {
             return tr("Records what is steered, until it is pressed again: a performance of the project");
         },
         "disc",
         {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R)}},
        false, [this](bool on) {
            if (on != m_session->isRecording())
                toggleRecording();
        });
    connect(m_session, &LiveSession::changed, record,
            [this, record] { record->setChecked(m_session->isRecording()); });
    actions.add({"live.restart",
                 group,
                 [] { return tr("&Begin anew"); },
                 [] { return tr("Forgets what was played, and begins where it began"); },
                 "first",
                 {}},
                [this] {
                    finishRecording();
                    m_session->restart();
                });
    actions.add({"live.addSequence",
                 group,
                 [] { return tr("&Add as a take"); },
                 [] { return tr("Adds the recorded clip to the takes: for graphs, animations, variations"); },
                 "sequence",
                 {}},
                [this] { addSequence(); });
    actions.add({"live.export",
                 group,
                 [] { return tr("E&xport the clip…"); },
                 [] { return tr("Writes the recorded clip into files"); },
                 "export",
                 {}},
                [this] { emit exportRequested(shownClip()); });
    offerClip();
}

QString LiveWorkspace::shownClip() const
{
    return findLive(m_context.document.project(), m_loaded.toStdString()) == nullptr
               ? QString()
               : QStringLiteral("live/") + m_loaded;
}

void LiveWorkspace::offerClip()
{
    for (const char* id : {"live.addSequence", "live.export"})
        m_context.actions.action(QLatin1String(id))->setEnabled(!shownClip().isEmpty());
}

void LiveWorkspace::toggle()
{
    if (m_session->isRunning())
        m_session->pause();
    else
        m_session->run();
}

void LiveWorkspace::toggleRecording()
{
    if (m_session->isRecording())
        finishRecording();
    else
        m_session->startRecording();
}

void LiveWorkspace::finishRecording()
{
    if (std::optional<LiveEntry> entry = m_session->stopRecording()) {
        entry->name = tr("performance").toStdString();
        m_context.selection.select({Section::Lives, addLive(m_context.document, std::move(*entry))});
    }
}

void LiveWorkspace::addSequence()
{
    const Project& project = m_context.document.project();
    const LiveEntry* live = findLive(project, m_loaded.toStdString());
    if (live == nullptr)
        return;
    SequenceEntry sequence;
    sequence.name = live->name;
    sequence.source = "clip:live/" + live->name;
    sequence.character = project.characters.size() > 1 ? characterNameOf(project, *live) : std::string();
    std::vector<SequenceEntry> added;
    added.push_back(std::move(sequence));
    addSequences(m_context.document, std::move(added));
}

} // namespace quadrille

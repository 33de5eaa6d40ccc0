// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/sessionkeeper.h"

#include "editor/context/editorcontext.h"
#include "editor/context/windowplace.h"
#include "editor/documents/projectpaths.h"
#include "editor/playback/clipscene.h"
#include "editor/playback/player.h"
#include "editor/workspaces/workspacetabs.h"
#include "widgets/viewport/viewport.h"

#include <QJsonArray>
#include <QMainWindow>
#include <array>
#include <utility>

namespace quadrille {

namespace {

constexpr QSize thumbnailSize(320, 200);

/// Actions that choose the shading, in the order of widgets::Shading.
constexpr std::array shadings{"view.textured", "view.clay", "view.wire"};

QJsonObject toJson(const widgets::Turntable& camera)
{
    return {{"target", QJsonArray{camera.target.x(), camera.target.y(), camera.target.z()}},
            {"yaw", camera.yaw},
            {"pitch", camera.pitch},
            {"distance", camera.distance}};
}

widgets::Turntable cameraFrom(const QJsonObject& json, widgets::Turntable camera)
{
    const QJsonArray target = json["target"].toArray();
    const auto number = [](const QJsonValue& value, float fallback) {
        return static_cast<float>(value.toDouble(fallback));
    };
    if (target.size() == 3)
        camera.target = {number(target[0], 0), number(target[1], 0), number(target[2], 0)};
    camera.yaw = number(json["yaw"], camera.yaw);
    camera.pitch = number(json["pitch"], camera.pitch);
    camera.distance = number(json["distance"], camera.distance);
    return camera;
}

} // namespace

SessionKeeper::SessionKeeper(EditorContext& context, WorkspaceTabs& workspaces, Workspace& sequences,
                             QMainWindow& window)
    : QObject(&window), m_context(context), m_workspaces(workspaces), m_sequences(sequences), m_window(window)
{
    connect(&context.document, &ProjectDocument::changed, this, &SessionKeeper::follow);
    connect(&sequences.scene(), &ClipScene::frameShown, this, &SessionKeeper::showView);
}

Session SessionKeeper::load(const std::filesystem::path& project)
{
    const KeptSession kept = loadSession(project);
    if (!kept.asideFile.isEmpty())
        emit putAside(kept.asideFile);
    return kept.session;
}

void SessionKeeper::restoreWindow()
{
    const Session session = load({});
    placeWindow(m_window, session.windowPlace);
    m_workspaces.setStates(session.docks);
}

void SessionKeeper::keepWindow()
{
    Session session;
    session.windowPlace = placeOf(m_window);
    session.docks = m_workspaces.states();
    saveSession(session, {});
}

void SessionKeeper::keep()
{
    if (m_context.document.isUntitled())
        return;
    const widgets::Viewport& viewport = m_sequences.viewport();
    Session session;
    session.windowPlace = placeOf(m_window);
    session.docks = m_workspaces.states();
    session.workspace = m_workspaces.current();
    session.selected = m_context.selection.sequences();
    session.shownSequence = m_context.selection.shownSequence();
    session.frame = m_sequences.player().frame().value;
    session.looks = m_workspaces.looks();
    session.view = {{"camera", toJson(viewport.camera())}, {"shading", static_cast<int>(viewport.shading())}};
    saveSession(session, m_context.document.file());
    // What was looked at last; a workspace that shows nothing says nothing about the project.
    Workspace* front = m_workspaces.currentWorkspace();
    Workspace& shown = front != nullptr && front->scene().frameCount() > 0 ? *front : m_sequences;
    const QImage picture = shown.viewport().snapshot({.size = thumbnailSize, .annotations = false});
    if (!picture.isNull())
        picture.save(thumbnailFile(toQString(m_context.document.file())));
}

void SessionKeeper::follow(const ChangeEvent& event)
{
    if (event.kind != ChangeEvent::Kind::Reset)
        return;
    m_pending.reset();
    if (m_context.document.isUntitled())
        return;
    Session session = load(m_context.document.file());
    if (session == Session{})
        return;
    placeWindow(m_window, session.windowPlace);
    m_workspaces.setStates(session.docks);
    m_workspaces.setLooks(session.looks);
    m_workspaces.select(session.workspace);
    session.selected.removeIf(
        [this](const QString& name) { return m_context.document.sequence(name) == nullptr; });
    if (!session.selected.isEmpty())
        m_context.selection.selectSequences(session.selected, session.shownSequence);
    m_pending = std::move(session);
}

void SessionKeeper::showView()
{
    const auto session = std::exchange(m_pending, std::nullopt);
    if (!session || m_context.selection.shownSequence() != session->shownSequence)
        return;
    widgets::Viewport& viewport = m_sequences.viewport();
    viewport.setCamera(cameraFrom(session->view["camera"].toObject(), viewport.camera()));
    const int shading = session->view["shading"].toInt();
    if (shading >= 0 && shading < static_cast<int>(shadings.size()))
        m_context.actions.action(QLatin1String(shadings.at(static_cast<std::size_t>(shading))))
            ->setChecked(true);
    if (session->frame > 0 && session->frame < m_sequences.scene().frameCount())
        m_sequences.player().goTo(session->frame);
}

} // namespace quadrille

#include "moc_sessionkeeper.cpp"

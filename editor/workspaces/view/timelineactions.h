// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QKeySequence>
#include <QObject>
#include <functional>

class QMenu;

namespace quadrille {

class SceneView;
struct EditorContext;

/// The actions of the menu Playback that are about a part of the frames, and about the ruler. They act on the
/// view of the workspace in front.
class TimelineActions : public QObject
{
    Q_OBJECT

public:
    /// \param view  the one in front; null for none.
    TimelineActions(EditorContext& context, std::function<SceneView*()> view, QObject* parent = nullptr);

    /// Another view came to the front, and takes what is on.
    void follow();

private:
    void add(const char* id, const std::function<QString()>& text, const std::function<QString()>& tip,
             const char* icon, const QKeySequence& key, std::function<void(SceneView&)> run);

    EditorContext& m_context;
    std::function<SceneView*()> m_view;
};

/// What a right click on a timeline offers besides what its workspace does. \param track  the row's; may be
/// empty.
void addTimelineMenu(QMenu& menu, SceneView& view, const EditorContext& context, const QString& track,
                     int frame);

} // namespace quadrille

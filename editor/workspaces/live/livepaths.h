// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QStringList>

namespace quadrille {

class Error;
class LiveSession;
struct EditorContext;
struct PathEntry;

namespace widgets {
class Viewport;
}

/// Paths that a session can follow: those of the character's animations, drawn in the workspace Animate, with
/// their obstacles. The one that is followed is seen in the view.
class LivePaths : public QObject
{
    Q_OBJECT

public:
    /// Refers to all of them.
    LivePaths(EditorContext& context, LiveSession& session, widgets::Viewport& viewport,
              QObject* parent = nullptr);

    /// Animations that have a path.
    QStringList names() const;
    /// The one whose path is followed; empty where it is steered by hand.
    const QString& chosen() const { return m_chosen; }
    /// Begins anew at the beginning of a path; empty: goes on by hand.
    void choose(const QString& animation);

signals:
    /// What is played by now is about to be begun anew: what is being recorded must be kept before.
    void beginning();
    /// Another one is followed, or there are others.
    void changed();
    /// The path cannot be followed.
    void failed(const quadrille::Error& error);

private:
    const PathEntry* pathOf(const QString& animation) const;
    void followSession();
    void showPath();

    EditorContext& m_context;
    LiveSession& m_session;
    widgets::Viewport& m_viewport;
    QString m_chosen;
};

} // namespace quadrille

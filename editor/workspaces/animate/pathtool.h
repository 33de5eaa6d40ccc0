// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/workspaces/animate/pathentries.h"
#include "widgets/tools/patheditor.h"

#include <QObject>
#include <functional>

class QAction;

namespace quadrille {

class CurrentAnimation;

/// Joins the path of the animation that is worked on with the view: what is drawn and dragged there becomes
/// edits that can be undone, and edits from elsewhere are shown.
class PathTool : public QObject
{
    Q_OBJECT

public:
    using Edit = std::function<void(PathEntry&)>;

    explicit PathTool(CurrentAnimation& animation, QObject* parent = nullptr);

    CurrentAnimation& animation() const { return m_animation; }
    widgets::PathEditor& editor() const { return *m_editor; }
    /// Null without one.
    const PathEntry* path() const;
    /// The length of its curve, in the project's unit.
    double length() const;
    /// Edits the path. \pre there is one. \param property  see setAnimation.
    void edit(const QString& text, const QString& property, const Edit& edit,
              EditPhase phase = EditPhase::Final);
    /// The height of a body's centre in the project's coordinates: at the first frame of the clip, without
    /// one that of a grown person's waist above the ground.
    double usualHeight() const;

    /// Begins to draw: a path, or what is beside one. Brings the workspace to the front. In that mode
    /// already, it ends drawing.
    void draw(widgets::PathEditor::Mode mode);
    /// Asks something of a stretch that is free yet, and selects it. It is half of what lies behind all
    /// others, or of the whole path where nothing does. \pre There is a path.
    void addSpan();
    /// Of the path, and of the one that is drawn next; so below.
    void setCurve(PathCurve curve);
    void setInSpace(bool inSpace);
    /// What a path begins with that is drawn next.
    const PathEntry& blank() const { return m_blank; }
    /// What is asked of a span, in a few words: "walk · 1.2 m/s".
    QString spanText(const PathSpanEntry& span) const;
    /// "walk" or "take 3, frames 10 – 40".
    QString framesText(const FrameChoice& frames) const;

signals:
    /// The path has other values, or there is another one.
    void changed();

private:
    /// A length along the path as it is written: ends of spans are rounded to millimetres.
    double alongPath(double length) const;
    void makeActions();
    void connectEditor();
    void refresh();
    void refreshActions();
    void describeSelection();
    void showMenu(const widgets::PathPart& part, double length, const QPoint& globalPosition);
    void takePoints(const std::vector<QVector3D>& points, widgets::PathEdit edit, bool committed);
    QAction* addAction(const char* id, std::function<QString()> text, std::function<QString()> tip,
                       const char* icon, const QKeySequence& shortcut, std::function<void()> run);

    CurrentAnimation& m_animation;
    widgets::PathEditor* m_editor;
    PathEntry m_blank;
    PathSpace m_space;
    QString m_shown; ///< the animation that the view shows the path of
};

} // namespace quadrille

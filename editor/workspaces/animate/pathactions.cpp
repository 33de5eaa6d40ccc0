// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The actions of paths.
#include "editor/context/editorcontext.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathtool.h"
#include "editor/workspaces/view/sceneview.h"

#include <QAction>
#include <QMenu>
#include <QSignalBlocker>

namespace quadrille {

using Mode = widgets::PathEditor::Mode;

QAction* PathTool::addAction(const char* id, std::function<QString()> text, std::function<QString()> tip,
                             const char* icon, const QKeySequence& shortcut, std::function<void()> run)
{
    QList<QKeySequence> shortcuts;
    if (!shortcut.isEmpty())
        shortcuts += shortcut;
    return m_animation.context().actions.add({QLatin1String(id), [] { return tr("Animate"); },
                                              std::move(text), std::move(tip), QLatin1String(icon),
                                              shortcuts},
                                             std::move(run));
}

void PathTool::makeActions()
{
    const auto addMode = [this](const char* id, std::function<QString()> text, std::function<QString()> tip,
                                const char* icon, const QKeySequence& shortcut, Mode mode) {
        addAction(id, std::move(text), std::move(tip), icon, shortcut, [this, mode] {
            draw(mode);
        })->setCheckable(true);
    };
    addMode(
        "animate.path.draw", [] { return tr("Draw a &path"); },
        [] {
            return tr(
                "Click for points, or drag a stroke; Return or a double click ends, Backspace takes the "
                "last point back");
        },
        "path", QKeySequence(Qt::Key_P), Mode::Draw);
    addMode(
        "animate.path.disc", [] { return tr("Add a &round obstacle"); },
        [] { return tr("Drag from the middle of a disc that the body stays out of"); }, "disc",
        QKeySequence(Qt::SHIFT | Qt::Key_O), Mode::Disc);
    addMode(
        "animate.path.polygon", [] { return tr("Add an obstacle with &corners"); },
        [] { return tr("Click corners; Return or a click on the first one ends"); }, "polygon",
        QKeySequence(), Mode::Polygon);
    m_animation.context().actions.addToggle(
        {"animate.path.show",
         [] { return tr("Animate"); },
         [] { return tr("Sho&w the path"); },
         [] { return tr("Show the path with its points, spans and obstacles in the view"); },
         "visible",
         {}},
        true, [this](bool shown) { m_editor->setActive(shown); });
    addAction(
        "animate.path.span", [] { return tr("Ask for frames or speed on a &span"); },
        [] { return tr("Only frames with a label, or a speed, on a part of the path"); }, "label",
        QKeySequence(Qt::SHIFT | Qt::Key_S), [this] { addSpan(); });
    addAction(
        "animate.path.reverse", [] { return tr("Re&verse the path"); }, [] { return tr("Begin at its end"); },
        "reverse", QKeySequence(),
        [this] {
            edit(tr("Reverse the path"), QStringLiteral("path points"),
                 [this](PathEntry& path) { path = reversed(path, m_space.metresPerUnit); });
        });
    addAction(
        "animate.path.close", [] { return tr("&Close the path"); },
        [] { return tr("Lead the path back to where it began"); }, "loop", QKeySequence(),
        [this] {
            edit(tr("Close the path"), QStringLiteral("path points"),
                 [](PathEntry& path) { path = closed(path); });
        });
    addAction(
        "animate.path.remove", [] { return tr("De&lete the path"); },
        [] { return tr("Take away the path with its spans and obstacles"); }, "delete", QKeySequence(),
        [this] {
            m_animation.edit(tr("Delete the path"), QStringLiteral("path"),
                             [](AnimationEntry& animation) { removePath(animation); });
        });
}

void PathTool::showMenu(const widgets::PathPart& part, double length, const QPoint& globalPosition)
{
    using Kind = widgets::PathPart::Kind;
    const ActionRegistry& actions = m_animation.context().actions;
    auto* menu = new QMenu(&m_animation.view());
    menu->setObjectName(QStringLiteral("pathMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (part.kind == Kind::Curve)
        menu->addAction(tr("&Insert a point here"), m_editor,
                        [this, length] { m_editor->insertPoint(length); });
    else
        menu->addAction(tr("&Delete"), m_editor, &widgets::PathEditor::removeSelected);
    if (part.kind == Kind::Point && m_editor->shape().kind == widgets::PathKind::Bezier)
        menu->addAction(tr("&Join the handles"), m_editor, &widgets::PathEditor::smoothSelected);
    menu->addSeparator();
    for (const char* id : {"animate.path.draw", "animate.path.span", "animate.path.disc",
                           "animate.path.polygon", "animate.path.reverse", "animate.path.close"})
        menu->addAction(actions.action(QLatin1String(id)));
    menu->popup(globalPosition);
}

void PathTool::refreshActions()
{
    const ActionRegistry& actions = m_animation.context().actions;
    const bool hasSequences = !m_animation.context().document.project().sequences.empty();
    const bool hasPath = path() != nullptr && path()->points.size() > 1;
    const auto showMode = [&](const char* id, Mode mode, bool enabled) {
        QAction* action = actions.action(QLatin1String(id));
        action->setChecked(m_editor->mode() == mode);
        action->setEnabled(enabled);
    };
    showMode("animate.path.draw", Mode::Draw, hasSequences);
    showMode("animate.path.disc", Mode::Disc, hasPath);
    showMode("animate.path.polygon", Mode::Polygon, hasPath);
    for (const char* id : {"animate.path.span", "animate.path.reverse", "animate.path.remove"})
        actions.action(QLatin1String(id))->setEnabled(hasPath);
    actions.action(QStringLiteral("animate.path.close"))
        ->setEnabled(hasPath && path()->points.size() > 2 && !isClosed(*path()));
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The actions of curves and parts.
#include "editor/context/editorcontext.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/variations/partedits.h"
#include "editor/workspaces/view/sceneview.h"

#include <QAction>
#include <QMenu>

namespace quadrille {

using Mode = widgets::SurfaceCurveEditor::Mode;

QAction* PartCurveTool::addAction(const char* id, std::function<QString()> text, std::function<QString()> tip,
                                  const char* icon, const QKeySequence& shortcut, std::function<void()> run)
{
    QList<QKeySequence> shortcuts;
    if (!shortcut.isEmpty())
        shortcuts += shortcut;
    return m_variation.context().actions.add({QLatin1String(id), [] { return tr("Variations"); },
                                              std::move(text), std::move(tip), QLatin1String(icon),
                                              shortcuts},
                                             std::move(run));
}

void PartCurveTool::makeActions()
{
    ActionRegistry& actions = m_variation.context().actions;
    addAction(
        "variations.parts.propose", [] { return tr("&Propose parts"); },
        [] { return tr("Cut the body into torso, arms and legs; takes the place of all curves and parts"); },
        "parts", QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_P), [this] { propose(); });
    addAction(
        "variations.curve.draw", [] { return tr("Draw a &curve"); },
        [] {
            return tr("Click points around a limb; the curve closes itself, Return or a click on the first "
                      "point ends");
        },
        "drawcurve", QKeySequence(Qt::Key_C), [this] { draw(); })
        ->setCheckable(true);
    addAction(
        "variations.curve.second", [] { return tr("Add a s&econd curve"); },
        [] { return tr("Beside the selected one, towards the end of the limb: a part needs two"); },
        "secondcurve", QKeySequence(), [this] { addSecondCurve(); });
    addAction(
        "variations.parts.add", [] { return tr("&Add a part"); },
        [] { return tr("From the selected curve and the one next to it, or one that is made"); }, "addpart",
        QKeySequence(Qt::SHIFT | Qt::Key_P), [this] { addPart(); });
    addAction(
        "variations.curve.mirror", [] { return tr("&Mirror to the other side"); },
        [] { return tr("Make the selected curve or part on the other side of the body, too"); }, "mirror",
        QKeySequence(Qt::SHIFT | Qt::Key_M), [this] { mirror(); });
    addAction(
        "variations.curve.shorten", [] { return tr("&Shorten the curve"); },
        [] { return tr("Lead it where the limb is thinnest nearby"); }, "shorten",
        QKeySequence(Qt::SHIFT | Qt::Key_H), [this] { shorten(); });
    addAction(
        "variations.parts.remove", [] { return tr("&Delete the curve or part"); },
        [] { return tr("Take away what is selected; curves of a part stay"); }, "delete", QKeySequence(),
        [this] { removeSelected(); });
    actions.addToggle({"variations.curve.snap",
                       [] { return tr("Variations"); },
                       [] { return tr("S&nap to creases"); },
                       [] { return tr("Points jump to creases near them, and curves follow them"); },
                       "crease",
                       {}},
                      m_drawing.snaps, [this](bool snaps) { setSnaps(snaps); });
    actions.addToggle({"variations.parts.show",
                       [] { return tr("Variations"); },
                       [] { return tr("Sho&w the parts"); },
                       [] { return tr("Colour the parts of the body and show their curves in the view"); },
                       "visible",
                       {}},
                      true, [this](bool) { emit visibilityRequested(); });
}

void PartCurveTool::showMenu(const widgets::SurfaceCurvePart& part, const QPoint& globalPosition)
{
    const ActionRegistry& actions = m_variation.context().actions;
    auto* menu = new QMenu(&m_variation.view());
    menu->setObjectName(QStringLiteral("partCurveMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (part.kind == widgets::SurfaceCurvePart::Kind::Point)
        menu->addAction(tr("&Delete the point"), m_editor, &widgets::SurfaceCurveEditor::removeSelected);
    for (const char* id : {"variations.curve.second", "variations.curve.mirror", "variations.curve.shorten",
                           "variations.parts.add", "variations.parts.remove"})
        menu->addAction(actions.action(QLatin1String(id)));
    menu->popup(globalPosition);
}

void PartCurveTool::refreshActions()
{
    const ActionRegistry& actions = m_variation.context().actions;
    const bool isReady = m_shownGraph != nullptr && !isBusy();
    const PartCurveEntry* curve = selectedCurve();
    const bool isWhole =
        curve != nullptr && m_shownGraph && m_cut.problemOfCurve(curve->curve.name) == nullptr;
    const PartEntry* part =
        m_selected.kind == PartSelection::Kind::Part ? findPart(m_body, m_selected.name) : nullptr;
    const auto enable = [&actions](const char* id, bool enabled) {
        actions.action(QLatin1String(id))->setEnabled(enabled);
    };
    enable("variations.parts.propose", isReady);
    enable("variations.curve.draw", m_shownGraph != nullptr);
    actions.action(QStringLiteral("variations.curve.draw"))->setChecked(m_editor->mode() == Mode::Draw);
    enable("variations.curve.second", isReady && isWhole);
    enable("variations.parts.add", isReady && !looseCurves().empty());
    enable("variations.curve.mirror",
           isReady && (isWhole || (part != nullptr && !part->part.curves.empty())));
    enable("variations.curve.shorten", isReady && isWhole);
    enable("variations.parts.remove", m_selected.kind != PartSelection::Kind::None);
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partcurveactions.h"

#include "editor/context/editorcontext.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/view/sceneview.h"

#include <QAction>
#include <QMenu>
#include <utility>

namespace quadrille {

using Mode = widgets::SurfaceCurveEditor::Mode;

PartCurveActions::PartCurveActions(PartCurveTool& tool, const PartCurveContent& content)
    : m_tool(tool), m_content(content)
{
    add(
        "variations.parts.propose", [] { return PartCurveTool::tr("&Propose parts"); },
        [] {
            return PartCurveTool::tr(
                "Cut the body into torso, arms and legs; takes the place of all curves and parts");
        },
        "parts", QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_P), [this] { m_tool.propose(); });
    add(
        "variations.curve.draw", [] { return PartCurveTool::tr("Draw a &curve"); },
        [] {
            return PartCurveTool::tr(
                "Click points around a limb; the curve closes itself, Return or a click on the first "
                "point ends");
        },
        "drawcurve", QKeySequence(Qt::Key_C), [this] { m_tool.draw(); })
        ->setCheckable(true);
    add(
        "variations.curve.second", [] { return PartCurveTool::tr("Add a s&econd curve"); },
        [] {
            return PartCurveTool::tr(
                "Beside the selected one, towards the end of the limb: a part needs two");
        },
        "secondcurve", QKeySequence(), [this] { m_tool.addSecondCurve(); });
    add(
        "variations.parts.add", [] { return PartCurveTool::tr("&Add a part"); },
        [] {
            return PartCurveTool::tr("From the selected curve and the one next to it, or one that is made");
        },
        "addpart", QKeySequence(Qt::SHIFT | Qt::Key_P), [this] { m_tool.addPart(); });
    add(
        "variations.curve.mirror", [] { return PartCurveTool::tr("&Mirror to the other side"); },
        [] {
            return PartCurveTool::tr("Make the selected curve or part on the other side of the body, too");
        },
        "mirror", QKeySequence(Qt::SHIFT | Qt::Key_M), [this] { m_tool.mirror(); });
    add(
        "variations.curve.shorten", [] { return PartCurveTool::tr("&Shorten the curve"); },
        [] { return PartCurveTool::tr("Lead it where the limb is thinnest nearby"); }, "shorten",
        QKeySequence(Qt::SHIFT | Qt::Key_H), [this] { m_tool.shorten(); });
    add(
        "variations.parts.remove", [] { return PartCurveTool::tr("&Delete the curve or part"); },
        [] { return PartCurveTool::tr("Take away what is selected; curves of a part stay"); }, "delete",
        QKeySequence(), [this] { m_tool.removeSelected(); });
    actions().addToggle(
        {"variations.curve.snap",
         [] { return PartCurveTool::tr("Variations"); },
         [] { return PartCurveTool::tr("S&nap to creases"); },
         [] { return PartCurveTool::tr("Points jump to creases near them, and curves follow them"); },
         "crease",
         {}},
        m_content.drawing.snaps, [this](bool snaps) { m_tool.setSnaps(snaps); });
    actions().addToggle(
        {"variations.parts.show",
         [] { return PartCurveTool::tr("Variations"); },
         [] { return PartCurveTool::tr("Sho&w the parts"); },
         [] { return PartCurveTool::tr("Colour the parts of the body and show their curves in the view"); },
         "visible",
         {}},
        true, [this](bool) { emit m_tool.visibilityRequested(); });
}

ActionRegistry& PartCurveActions::actions() const
{
    return m_tool.variation().context().actions;
}

QAction* PartCurveActions::add(const char* id, std::function<QString()> text, std::function<QString()> tip,
                               const char* icon, const QKeySequence& shortcut, std::function<void()> run)
{
    QList<QKeySequence> shortcuts;
    if (!shortcut.isEmpty())
        shortcuts += shortcut;
    return actions().add({QLatin1String(id), [] { return PartCurveTool::tr("Variations"); }, std::move(text),
                          std::move(tip), QLatin1String(icon), shortcuts},
                         std::move(run));
}

void PartCurveActions::showMenu(const widgets::SurfaceCurvePart& part, const QPoint& globalPosition)
{
    auto* menu = new QMenu(&m_tool.variation().view());
    menu->setObjectName(QStringLiteral("partCurveMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (part.kind == widgets::SurfaceCurvePart::Kind::Point)
        menu->addAction(PartCurveTool::tr("&Delete the point"), &m_tool.editor(),
                        &widgets::SurfaceCurveEditor::removeSelected);
    for (const char* id : {"variations.curve.second", "variations.curve.mirror", "variations.curve.shorten",
                           "variations.parts.add", "variations.parts.remove"})
        menu->addAction(actions().action(QLatin1String(id)));
    menu->popup(globalPosition);
}

void PartCurveActions::refresh()
{
    const bool isReady = m_content.graph != nullptr && !m_tool.isBusy();
    const PartCurveEntry* curve = m_content.selectedCurve();
    const bool isWhole =
        curve != nullptr && m_content.graph && m_content.cut.problemOfCurve(curve->curve.name) == nullptr;
    const PartEntry* part = m_content.selectedPart();
    const auto enable = [this](const char* id, bool enabled) {
        actions().action(QLatin1String(id))->setEnabled(enabled);
    };
    enable("variations.parts.propose", isReady);
    enable("variations.curve.draw", m_content.graph != nullptr);
    actions()
        .action(QStringLiteral("variations.curve.draw"))
        ->setChecked(m_tool.editor().mode() == Mode::Draw);
    enable("variations.curve.second", isReady && isWhole);
    enable("variations.parts.add", isReady && !m_content.looseCurves().empty());
    enable("variations.curve.mirror",
           isReady && (isWhole || (part != nullptr && !part->part.curves.empty())));
    enable("variations.curve.shorten", isReady && isWhole);
    enable("variations.parts.remove", m_content.selected.kind != PartSelection::Kind::None);
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partcurvetool.h"

#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/bodysurface.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/partcurveactions.h"
#include "editor/workspaces/variations/partcurvegestures.h"
#include "editor/workspaces/variations/partcurvejobs.h"
#include "editor/workspaces/variations/partcurveview.h"
#include "editor/workspaces/variations/partedits.h"
#include "editor/workspaces/view/sceneview.h"
#include "widgets/theme/theme.h"

#include <QAction>

namespace quadrille {

using widgets::MessageStrip;
using widgets::SurfaceCurveEditor;
using widgets::SurfaceCurvePart;

PartCurveTool::PartCurveTool(CurrentVariation& variation, QObject* parent)
    : QObject(parent)
    , m_variation(variation)
    , m_surface(new BodySurface(variation, this))
    , m_editor(new SurfaceCurveEditor(variation.view().viewport(), this))
    , m_content{.graph = {},
                .body = {},
                .cut = {},
                .selected = {},
                .drawing = variation.context().settings.curveDrawing()}
    , m_gestures(new PartCurveGestures(m_content, *m_editor, this))
    , m_jobs(new PartCurveJobs(m_content, variation.context().jobs, this))
    , m_view(std::make_unique<PartCurveView>(m_content, variation.view(), *m_editor))
    , m_actions(std::make_unique<PartCurveActions>(*this, m_content))
{
    m_editor->setActive(false);
    connectParts();
    connect(&variation, &CurrentVariation::bodyChanged, this, &PartCurveTool::refresh);
    connect(m_surface, &BodySurface::changed, this, &PartCurveTool::refresh);
    connect(&variation.view().scene(), &ClipScene::changed, this, [this] {
        m_view->refreshFigure();
        m_view->refreshColors();
    });
    connect(&variation.view().viewport(), &widgets::Viewport::figureChanged, this,
            [this] { m_view->frameFigure(); });
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &PartCurveTool::refresh);
    retranslates(&variation.view(), [this] { refresh(); });
}

PartCurveTool::~PartCurveTool() = default;

void PartCurveTool::connectParts()
{
    connect(m_editor, &SurfaceCurveEditor::curveRemovalRequested, this, [this](int curve) {
        if (const PartCurveEntry* entry = m_content.curveAt(curve)) {
            select({PartSelection::Kind::Curve, entry->curve.name});
            removeSelected();
        }
    });
    connect(m_editor, &SurfaceCurveEditor::modeChanged, this, &PartCurveTool::followMode);
    connect(m_editor, &SurfaceCurveEditor::selectionChanged, this, &PartCurveTool::followSelection);
    connect(m_editor, &SurfaceCurveEditor::contextMenuRequested, this,
            [this](const SurfaceCurvePart& part, const QPoint& globalPosition) {
                m_actions->showMenu(part, globalPosition);
            });
    connect(m_gestures, &PartCurveGestures::edited, this, &PartCurveTool::edit);
    connect(m_jobs, &PartCurveJobs::begun, this, [this] { emit told({}); });
    connect(m_jobs, &PartCurveJobs::busyChanged, this, [this] {
        m_actions->refresh();
        emit changed();
    });
    connect(m_jobs, &PartCurveJobs::failed, this, [this](const Error& error) {
        const ErrorText why = describe(error);
        emit told({MessageStrip::Kind::Error, why.sentence, why.remedy});
    });
    connect(m_jobs, &PartCurveJobs::computed, this, &PartCurveTool::take);
}

QString PartCurveTool::sentence(const Error& error)
{
    return describe(error).sentence;
}

bool PartCurveTool::isBusy() const
{
    return m_jobs->isBusy();
}

void PartCurveTool::setActive(bool active)
{
    if (active == m_view->isActive())
        return;
    m_view->setActive(active);
    refresh();
}

void PartCurveTool::setSnaps(bool snaps)
{
    m_content.drawing.snaps = snaps;
    m_variation.context().actions.action(QStringLiteral("variations.curve.snap"))->setChecked(snaps);
    keepDrawing();
}

void PartCurveTool::setSnapRadius(double metres)
{
    m_content.drawing.snapRadius = metres;
    keepDrawing();
}

void PartCurveTool::setOverlap(double metres)
{
    m_content.drawing.overlap = metres;
    keepDrawing();
}

void PartCurveTool::keepDrawing()
{
    m_variation.context().settings.setCurveDrawing(m_content.drawing);
    emit changed();
}

void PartCurveTool::edit(const QString& text, const QString& property, const Edit& edit, EditPhase phase)
{
    emit told({});
    m_variation.view().scene().keepCamera(); // who draws has chosen the view
    m_variation.editBody(text, property, edit, phase);
}

void PartCurveTool::take(const QString& text, const BodyPartsEntry& body, const PartSelection& selection)
{
    edit(text, QStringLiteral("parts"), [&body](BodyPartsEntry& before) { before = body; });
    if (selection.kind != PartSelection::Kind::None)
        select(selection);
}

void PartCurveTool::refresh()
{
    m_content.body = m_variation.body();
    const auto graph = m_surface->graph();
    const bool isOtherSurface = graph != m_content.graph;
    m_gestures->forget(isOtherSurface);
    if (isOtherSurface) {
        m_content.graph = graph;
        m_view->forgetSurface();
        m_jobs->forgetSurface();
    }
    m_content.cut = graph ? cutBody(*graph, m_content.body) : PartCut();
    const auto& problems = m_content.cut.problems;
    m_variation.context().bodies.set(
        m_variation.character(), problems.empty() ? QString() : describe(problems.front().error).oneLine());
    const bool isThere = m_content.selectedCurve() != nullptr || m_content.selectedPart() != nullptr;
    const bool isGone = m_content.selected.kind != PartSelection::Kind::None && !isThere;
    if (isGone)
        m_content.selected = {};
    m_view->refreshFigure();
    m_view->refreshCurves(m_gestures->drawn());
    m_view->refreshColors();
    m_actions->refresh();
    if (isGone)
        emit selectionChanged();
    emit changed();
}

void PartCurveTool::select(const PartSelection& selection)
{
    if (selection == m_content.selected)
        return;
    m_content.selected = selection;
    if (selection.kind == PartSelection::Kind::Curve) {
        const SurfaceCurvePart part{SurfaceCurvePart::Kind::Curve, m_content.indexOf(selection.name), 0};
        if (m_editor->selected().kind == SurfaceCurvePart::Kind::None ||
            m_editor->selected().curve != part.curve)
            m_editor->setSelected(part);
    } else {
        m_editor->setSelected({});
    }
    m_actions->refresh();
    emit selectionChanged();
}

void PartCurveTool::followMode(SurfaceCurveEditor::Mode mode)
{
    if (mode == SurfaceCurveEditor::Mode::Edit)
        m_gestures->finishDrawing();
    m_actions->refresh();
    emit changed();
}

void PartCurveTool::followSelection()
{
    const SurfaceCurvePart& part = m_editor->selected();
    if (part.kind != SurfaceCurvePart::Kind::None) {
        if (const PartCurveEntry* entry = m_content.curveAt(part.curve))
            select({PartSelection::Kind::Curve, entry->curve.name});
    } else if (m_content.selected.kind == PartSelection::Kind::Curve) {
        select({});
    }
    m_view->describeSelection();
}

void PartCurveTool::propose()
{
    const auto pose = m_surface->pose();
    const EditorContext& context = m_variation.context();
    const MeshSequence* sequence =
        pose ? context.media.sequence(QString::fromStdString(pose->sequence)) : nullptr;
    if (sequence == nullptr || !m_content.graph)
        return;
    emit panelRequested();
    m_jobs->propose(sequence->topology, context.document.project().settings.axes.up);
}

void PartCurveTool::draw()
{
    using Mode = widgets::SurfaceCurveEditor::Mode;
    EditorContext& context = m_variation.context();
    context.actions.action(QStringLiteral("workspace.variations"))->trigger();
    context.actions.action(QStringLiteral("variations.parts.show"))->setChecked(true);
    emit panelRequested();
    m_variation.view().player().pause(); // what is clicked on is to stand still
    m_editor->setMode(m_editor->mode() == Mode::Draw ? Mode::Edit : Mode::Draw);
    m_variation.view().viewport().setTool(widgets::Viewport::Tool::Navigate);
    m_variation.view().viewport().setFocus();
}

void PartCurveTool::addPart()
{
    const std::vector<std::string> curves = m_content.curvesForPart();
    if (curves.empty())
        return;
    const PartCurveEntry first = *findCurve(m_content.body, curves.front());
    const NewPart part{.name = freePartName(m_content.body, tr("part").toStdString()),
                       .root = tr("body").toStdString(),
                       .parent = m_content.cut.partOf(first.curve.vertices),
                       .curve = first};
    if (curves.size() < 2) {
        m_jobs->addPart(part);
        return;
    }
    edit(tr("Add a part"), QStringLiteral("parts"),
         [&](BodyPartsEntry& body) { quadrille::addPart(body, part.name, part.root, part.parent, curves); });
    select({PartSelection::Kind::Part, part.name});
}

void PartCurveTool::addSecondCurve()
{
    m_jobs->addSecondCurve();
}

void PartCurveTool::mirror()
{
    m_jobs->mirror();
}

void PartCurveTool::shorten()
{
    m_jobs->shorten();
}

void PartCurveTool::removeSelected()
{
    const QString name = QString::fromStdString(m_content.selected.name);
    if (m_content.selected.kind == PartSelection::Kind::Part) {
        edit(tr("Delete a part"), QStringLiteral("parts"),
             [part = m_content.selected.name](BodyPartsEntry& body) { removePart(body, part); });
        return;
    }
    if (m_content.selectedCurve() == nullptr)
        return;
    const std::vector<std::string> users = partsWith(m_content.body, m_content.selected.name);
    edit(tr("Delete a curve"), QStringLiteral("curves"),
         [curve = m_content.selected.name](BodyPartsEntry& body) { removeCurve(body, curve); });
    if (!users.empty())
        emit told({MessageStrip::Kind::Warning,
                   tr("The curve “%1” bounded the part “%2”, which lacks a curve now.")
                       .arg(name, QString::fromStdString(users.front())),
                   tr("Undo, draw another one, or choose one for the part.")});
}

bool PartCurveTool::rename(const PartSelection& which, const QString& name)
{
    const std::string wanted = name.trimmed().toStdString();
    if (wanted.empty() || wanted == which.name)
        return wanted == which.name;
    const bool isCurve = which.kind == PartSelection::Kind::Curve;
    const bool isTaken =
        isCurve ? findCurve(m_content.body, wanted) != nullptr : findPart(m_content.body, wanted) != nullptr;
    if (isTaken) {
        emit told({MessageStrip::Kind::Error,
                   (isCurve ? tr("There is a curve “%1” already.") : tr("There is a part “%1” already."))
                       .arg(name.trimmed()),
                   tr("Choose another name.")});
        return false;
    }
    const PartSelection renamed{which.kind, wanted};
    const bool wasSelected = m_content.selected == which;
    edit(isCurve ? tr("Rename a curve") : tr("Rename a part"), QStringLiteral("names"),
         [&](BodyPartsEntry& body) {
             if (isCurve)
                 renameCurve(body, which.name, wanted);
             else
                 renamePart(body, which.name, wanted);
         });
    if (wasSelected)
        select(renamed);
    return true;
}

void PartCurveTool::takeShownPose()
{
    const ClipScene& scene = m_variation.view().scene();
    if (scene.shown().isEmpty())
        return;
    const NamedFrame pose{.sequence = scene.shown().back().toStdString(), .frame = scene.frame()};
    edit(tr("Choose the pose that curves are drawn in"), QStringLiteral("pose"),
         [&pose](BodyPartsEntry& body) { body.pose = pose; });
}

} // namespace quadrille

#include "moc_partcurvetool.cpp"

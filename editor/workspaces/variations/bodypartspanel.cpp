// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/bodypartspanel.h"

#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/fields/actionbutton.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/bodypartstree.h"
#include "editor/workspaces/variations/bodysurface.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/partform.h"
#include "editor/workspaces/workspace.h"
#include "widgets/controls/messagestrip.h"

#include <QAction>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedLayout>
#include <QToolButton>

namespace quadrille {

using widgets::MessageStrip;

namespace {

constexpr int partsMargin = 12;
constexpr int partsGap = 8;

QAction* actionOf(const PartCurveTool& tool, const char* id)
{
    return tool.variation().context().actions.action(QLatin1String(id));
}

QDoubleSpinBox* lengthField(const char* name, double most, double step)
{
    auto* field = new QDoubleSpinBox;
    field->setObjectName(QLatin1String(name));
    field->setRange(step, most);
    field->setDecimals(1);
    field->setSingleStep(step);
    field->setAlignment(Qt::AlignRight);
    field->setKeyboardTracking(false);
    field->setFont(widgets::Theme::tabularFont(field->font()));
    return field;
}

void setValue(QDoubleSpinBox* field, double value)
{
    const QSignalBlocker quiet(field);
    field->setValue(value);
}

} // namespace

BodyPartsPanel::BodyPartsPanel(PartCurveTool& tool, QWidget* parent)
    : QWidget(parent)
    , m_tool(tool)
    , m_pages(new QStackedLayout(this))
    , m_emptyNotice(new MessageStrip)
    , m_notice(new MessageStrip)
    , m_problem(new MessageStrip)
    , m_offer(new MessageStrip)
    , m_tree(new BodyPartsTree(tool))
{
    setObjectName(QStringLiteral("bodyPartsPanel"));
    m_emptyNotice->setObjectName(QStringLiteral("bodyPartsEmptyNotice"));
    m_notice->setObjectName(QStringLiteral("bodyPartsNotice"));
    m_problem->setObjectName(QStringLiteral("bodyPartsProblem"));
    m_offer->setObjectName(QStringLiteral("bodyPartsOffer"));
    m_pages->addWidget(makeEmptyPage());
    m_pages->addWidget(makeContent());
    connectTool();
    retranslates(this, [this] { retranslate(); });
}

QWidget* BodyPartsPanel::makeEmptyPage()
{
    auto* page = new QWidget;
    m_emptyText = new QLabel;
    m_emptyText->setWordWrap(true);
    m_emptyText->setAlignment(Qt::AlignHCenter);
    m_emptyText->setForegroundRole(QPalette::PlaceholderText);
    m_propose = new QPushButton;
    m_propose->setObjectName(QStringLiteral("proposeParts"));
    m_draw = new QPushButton;
    m_draw->setObjectName(QStringLiteral("drawCurve"));
    connect(m_propose, &QPushButton::clicked, actionOf(m_tool, "variations.parts.propose"),
            &QAction::trigger);
    connect(m_draw, &QPushButton::clicked, actionOf(m_tool, "variations.curve.draw"), &QAction::trigger);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(2 * partsMargin, partsMargin, 2 * partsMargin, partsMargin);
    column->setSpacing(partsGap);
    column->addWidget(m_emptyNotice);
    column->addStretch(1);
    column->addWidget(m_emptyText);
    column->addSpacing(4);
    column->addWidget(m_propose, 0, Qt::AlignHCenter);
    column->addWidget(m_draw, 0, Qt::AlignHCenter);
    column->addStretch(2);
    return page;
}

QWidget* BodyPartsPanel::makeTools()
{
    auto* tools = new QWidget;
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(partsGap, 4, partsGap, 4);
    row->setSpacing(4);
    const auto add = [this, row](const char* id) {
        QToolButton* button = makeActionButton(actionOf(m_tool, id));
        button->setObjectName(QLatin1String("panel.") + QLatin1String(id));
        row->addWidget(button);
    };
    for (const char* id : {"variations.curve.draw", "variations.curve.second", "variations.curve.mirror",
                           "variations.curve.shorten", "variations.parts.add"})
        add(id);
    row->addStretch(1);
    for (const char* id : {"variations.parts.propose", "variations.parts.show", "variations.parts.remove"})
        add(id);
    return tools;
}

QWidget* BodyPartsPanel::makeSettings()
{
    m_snaps = new QCheckBox;
    m_snaps->setObjectName(QStringLiteral("snapToCreases"));
    m_radius = lengthField("snapRadius", 20.0, 0.5);
    m_overlapLabel = new QLabel;
    m_overlap = lengthField("partOverlap", 50.0, 0.5);
    m_overlapLabel->setBuddy(m_overlap);
    m_poseLabel = new QLabel;
    m_pose = new QLabel;
    m_pose->setObjectName(QStringLiteral("drawingPose"));
    m_takePose = new QPushButton;
    m_takePose->setObjectName(QStringLiteral("takePose"));
    auto* settings = new QWidget;
    auto* grid = new QGridLayout(settings);
    grid->setContentsMargins(partsMargin, partsGap, partsMargin, partsGap);
    grid->setHorizontalSpacing(partsGap);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(0, 1);
    grid->addWidget(m_snaps, 0, 0);
    grid->addWidget(m_radius, 0, 1);
    grid->addWidget(m_overlapLabel, 1, 0);
    grid->addWidget(m_overlap, 1, 1);
    auto* pose = new QHBoxLayout;
    pose->setSpacing(partsGap);
    pose->addWidget(m_poseLabel);
    pose->addWidget(m_pose, 1);
    pose->addWidget(m_takePose);
    grid->addLayout(pose, 2, 0, 1, 2);
    connect(m_snaps, &QCheckBox::toggled, &m_tool, &PartCurveTool::setSnaps);
    connect(m_radius, &QDoubleSpinBox::valueChanged, this,
            [this](double centimetres) { m_tool.setSnapRadius(centimetres / 100); });
    connect(m_overlap, &QDoubleSpinBox::valueChanged, this,
            [this](double centimetres) { m_tool.setOverlap(centimetres / 100); });
    connect(m_takePose, &QPushButton::clicked, &m_tool, &PartCurveTool::takeShownPose);
    return settings;
}

QWidget* BodyPartsPanel::makeContent()
{
    const auto inset = [](QWidget* widget) {
        auto* row = new QHBoxLayout;
        row->setContentsMargins(partsGap, 0, partsGap, 4);
        row->addWidget(widget);
        return row;
    };
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeTools());
    column->addLayout(inset(m_notice));
    column->addWidget(m_tree, 1);
    column->addLayout(inset(m_problem));
    column->addLayout(inset(m_offer));
    column->addWidget(new PartForm(m_tool));
    column->addWidget(makeSettings());
    return content;
}

void BodyPartsPanel::connectTool()
{
    connect(&m_tool, &PartCurveTool::changed, this, &BodyPartsPanel::refresh);
    connect(&m_tool, &PartCurveTool::selectionChanged, this, &BodyPartsPanel::refreshProblem);
    connect(&m_tool, &PartCurveTool::told, this, qOverload<const PartNotice&>(&BodyPartsPanel::show));
    connect(&m_tool, &PartCurveTool::panelRequested, this, [this] { Workspace::showPanel(this); });
    connect(m_offer, &MessageStrip::actionTriggered, actionOf(m_tool, "variations.parts.add"),
            &QAction::trigger);
}

void BodyPartsPanel::retranslate()
{
    setAccessibleName(tr("Body parts"));
    m_propose->setText(tr("Propose parts"));
    m_draw->setText(tr("Draw a curve"));
    m_propose->setToolTip(tr("Cut the body into torso, arms and legs"));
    m_draw->setToolTip(tr("Click points around a limb (C)"));
    m_snaps->setText(tr("Snap to creases within"));
    const QString snapTip =
        tr("A point that is put down jumps to the nearest crease; hold Alt to put it where the pointer is");
    m_snaps->setToolTip(snapTip);
    m_radius->setToolTip(snapTip);
    m_radius->setAccessibleName(tr("Radius of snapping"));
    m_radius->setSuffix(tr(" cm"));
    m_overlapLabel->setText(tr("Between two curves"));
    m_overlap->setSuffix(tr(" cm"));
    m_overlap->setAccessibleName(tr("Distance between the two curves of a part"));
    m_overlap->setToolTip(
        tr("How wide the strip is that a part shares with its parent, for curves that are made"));
    m_poseLabel->setText(tr("Pose"));
    m_pose->setToolTip(tr("Curves follow the surface as it is in this pose"));
    m_takePose->setText(tr("Use the shown one"));
    m_takePose->setToolTip(tr("Draw curves in the pose that the view shows"));
    refresh();
}

void BodyPartsPanel::refresh()
{
    const BodyPartsEntry& body = m_tool.body();
    const bool isDrawing = m_tool.editor().mode() == widgets::SurfaceCurveEditor::Mode::Draw;
    const bool isEmpty = body.curves.empty() && body.parts.empty() && !isDrawing;
    m_pages->setCurrentIndex(isEmpty ? 0 : 1);
    const auto pose = m_tool.surface().pose();
    const auto& error = m_tool.surface().error();
    if (error)
        m_emptyText->setText(describe(*error).oneLine());
    else if (!pose)
        m_emptyText->setText(tr("Parts belong to a body: import a sequence first."));
    else if (m_tool.surface().isLoading())
        m_emptyText->setText(tr("Reading the body …"));
    else
        m_emptyText->setText(
            tr("Variations are learned part by part. Curves around the limbs say where the parts meet: have "
               "torso, arms and legs proposed, or draw curves on the body."));
    m_propose->setEnabled(actionOf(m_tool, "variations.parts.propose")->isEnabled());
    m_draw->setEnabled(actionOf(m_tool, "variations.curve.draw")->isEnabled());
    const QSignalBlocker quiet(m_snaps);
    m_snaps->setChecked(m_tool.snaps());
    m_radius->setEnabled(m_tool.snaps());
    setValue(m_radius, m_tool.snapRadius() * 100);
    setValue(m_overlap, m_tool.overlap() * 100);
    m_pose->setText(
        pose ? tr("%1, frame %2").arg(QString::fromStdString(pose->sequence)).arg(pose->frame.value)
             : QStringLiteral("–"));
    m_takePose->setEnabled(!m_tool.variation().view().scene().isEmpty());
    refreshProblem();
    refreshOffer();
}

/// What is wrong with what is selected; without a selection, the first thing that is wrong.
void BodyPartsPanel::refreshProblem()
{
    const PartCut& cut = m_tool.cut();
    const PartSelection& selected = m_tool.selected();
    const PartProblem* problem =
        selected.kind == PartSelection::Kind::Curve  ? cut.problemOfCurve(selected.name)
        : selected.kind == PartSelection::Kind::Part ? cut.problemOfPart(selected.name)
                                                     : nullptr;
    if (problem == nullptr && !cut.problems.empty())
        problem = &cut.problems.front();
    if (problem == nullptr) {
        m_problem->clear();
        return;
    }
    const ErrorText text = describe(problem->error);
    m_problem->show(MessageStrip::Kind::Error, text.placed(), text.remedy);
}

/// A part from the curves that bound none.
void BodyPartsPanel::refreshOffer()
{
    const auto loose = m_tool.looseCurves();
    const bool isDrawing = m_tool.editor().mode() == widgets::SurfaceCurveEditor::Mode::Draw;
    const auto name = [&loose](std::size_t i) { return QString::fromStdString(loose[i]); };
    if (loose.empty() || isDrawing || m_tool.isBusy()) {
        m_offer->clear();
        return;
    }
    if (loose.size() == 1)
        m_offer->show(MessageStrip::Kind::Info, tr("The curve “%1” bounds no part yet.").arg(name(0)),
                      tr("A part needs two: draw another, or let one be made beside it."));
    else
        m_offer->show(MessageStrip::Kind::Info,
                      tr("The curves “%1” and “%2” bound no part yet.").arg(name(0), name(1)));
    m_offer->setAction(tr("Add a part"));
}

void BodyPartsPanel::show(const PartNotice& notice)
{
    for (MessageStrip* strip : {m_notice, m_emptyNotice}) {
        if (notice.sentence.isEmpty())
            strip->clear();
        else
            strip->show(notice.kind, notice.sentence, notice.remedy);
    }
}

} // namespace quadrille

#include "moc_bodypartspanel.cpp"

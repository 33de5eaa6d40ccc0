// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/pathpanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/partlist.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathfields.h"
#include "editor/workspaces/animate/pathforms.h"
#include "editor/workspaces/animate/pathpoints.h"
#include "editor/workspaces/animate/pathtool.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedLayout>
#include <QToolButton>

namespace quadrille {

using widgets::PathPart;

namespace {

constexpr int pathMargin = 12;
constexpr int pathGap = 8;

QToolButton* buttonFor(const EditorContext& context, const char* action)
{
    QToolButton* button = makeActionButton(context.actions.action(QLatin1String(action)));
    button->setObjectName(QLatin1String("panel.") + QLatin1String(action));
    return button;
}

QLabel* heading()
{
    auto* label = new QLabel;
    QFont font = label->font();
    font.setWeight(QFont::DemiBold);
    label->setFont(font);
    return label;
}

/// A title with buttons at its end.
QHBoxLayout* titleRow(QLabel* title, const QList<QToolButton*>& buttons)
{
    auto* row = new QHBoxLayout;
    row->setContentsMargins(pathMargin, pathGap, pathGap, 0);
    row->setSpacing(4);
    row->addWidget(title, 1);
    for (QToolButton* button : buttons)
        row->addWidget(button);
    return row;
}

} // namespace

PathPanel::PathPanel(PathTool& tool, QWidget* parent)
    : QWidget(parent)
    , m_tool(tool)
    , m_pages(new QStackedLayout(this))
    , m_form(new PathForm(tool))
    , m_points(new PathPoints(tool))
    , m_spans(new PartList(QStringLiteral("pathSpans")))
    , m_span(new SpanForm(tool))
    , m_obstacles(new PartList(QStringLiteral("pathObstacles")))
    , m_obstacle(new ObstacleForm(tool))
    , m_pointsTitle(heading())
    , m_spansTitle(heading())
    , m_obstaclesTitle(heading())
{
    setObjectName(QStringLiteral("pathPanel"));
    m_pages->addWidget(makeEmptyPage());
    m_pages->addWidget(makeContent());
    connectLists();
    connect(&tool, &PathTool::changed, this, &PathPanel::refresh);
    connect(&tool.animation(), &CurrentAnimation::resultChanged, this, [this] {
        m_form->refresh();
        m_span->refresh();
    });
    connect(&tool.editor(), &widgets::PathEditor::selectionChanged, this, &PathPanel::refreshSelection);
    retranslates(this, [this] { retranslate(); });
}

QWidget* PathPanel::makeEmptyPage()
{
    auto* page = new QWidget;
    m_emptyText = new QLabel;
    m_emptyText->setWordWrap(true);
    m_emptyText->setAlignment(Qt::AlignHCenter);
    m_emptyText->setForegroundRole(QPalette::PlaceholderText);
    m_draw = new QPushButton;
    m_draw->setObjectName(QStringLiteral("drawPath"));
    connect(m_draw, &QPushButton::clicked,
            m_tool.animation().context().actions.action(QStringLiteral("animate.path.draw")),
            &QAction::trigger);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(2 * pathMargin, pathMargin, 2 * pathMargin, pathMargin);
    column->setSpacing(pathMargin);
    column->addStretch(1);
    column->addWidget(m_emptyText);
    column->addWidget(m_draw, 0, Qt::AlignHCenter);
    column->addStretch(2);
    return page;
}

QWidget* PathPanel::makeTools()
{
    const EditorContext& context = m_tool.animation().context();
    auto* tools = new QWidget;
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(pathGap, 4, pathGap, 0);
    row->setSpacing(4);
    for (const char* action : {"animate.path.draw", "animate.path.reverse", "animate.path.close"})
        row->addWidget(buttonFor(context, action));
    row->addStretch(1);
    row->addWidget(buttonFor(context, "animate.path.remove"));
    return tools;
}

QWidget* PathPanel::makeContent()
{
    const EditorContext& context = m_tool.animation().context();
    const auto inset = [](QWidget* widget) {
        auto* row = new QHBoxLayout;
        row->setContentsMargins(pathMargin, 4, pathMargin, 0);
        row->addWidget(widget);
        return row;
    };
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, pathGap);
    column->setSpacing(0);
    column->addWidget(makeTools());
    column->addWidget(m_form);
    column->addLayout(titleRow(m_pointsTitle, {}));
    column->addLayout(inset(m_points));
    column->addLayout(titleRow(m_spansTitle, {buttonFor(context, "animate.path.span")}));
    column->addLayout(inset(m_spans));
    column->addWidget(m_span);
    column->addLayout(titleRow(m_obstaclesTitle, {buttonFor(context, "animate.path.disc"),
                                                  buttonFor(context, "animate.path.polygon")}));
    column->addLayout(inset(m_obstacles));
    column->addWidget(m_obstacle);
    column->addStretch(1);
    return verticalScroll(content);
}

void PathPanel::connectLists()
{
    connect(m_spans, &PartList::currentRowChanged, this, [this](int row) {
        if (row >= 0)
            m_tool.editor().setSelected({PathPart::Kind::StretchStart, row, 0});
    });
    connect(m_obstacles, &PartList::currentRowChanged, this, [this](int row) {
        if (row >= 0)
            m_tool.editor().setSelected({PathPart::Kind::Obstacle, row, 0});
    });
    connect(m_spans, &PartList::deletionRequested, &m_tool.editor(),
            &widgets::PathEditor::stretchDeletionRequested);
    connect(m_obstacles, &PartList::deletionRequested, &m_tool.editor(),
            &widgets::PathEditor::obstacleDeletionRequested);
}

void PathPanel::retranslate()
{
    m_emptyText->setText(
        tr("A path says where the body goes. Click points on the ground, or drag a line over "
           "it; the curve can be moved, labelled and timed afterwards."));
    m_draw->setText(tr("Draw a path"));
    m_draw->setToolTip(tr("Click points on the ground, or drag a line over it (P)"));
    m_pointsTitle->setText(tr("Points"));
    m_spansTitle->setText(tr("Spans"));
    m_obstaclesTitle->setText(tr("Obstacles"));
    m_points->setAccessibleName(tr("Points of the path"));
    m_points->setToolTip(tr("Coordinates of the points; a double click edits one"));
    m_spans->setAccessibleName(tr("Spans of the path"));
    m_spans->setToolTip(tr("Parts of the path on which frames or a speed are asked for"));
    m_obstacles->setAccessibleName(tr("Obstacles"));
    m_obstacles->setToolTip(tr("Parts of the ground that the body’s centre stays out of"));
    refresh();
}

void PathPanel::refresh()
{
    const bool hasPath = m_tool.path() != nullptr;
    m_pages->setCurrentIndex(hasPath ? 1 : 0);
    m_draw->setEnabled(
        m_tool.animation().context().actions.action(QStringLiteral("animate.path.draw"))->isEnabled());
    m_form->refresh();
    m_points->refresh();
    fillSpans();
    fillObstacles();
    refreshSelection();
}

void PathPanel::fillSpans()
{
    QStringList texts;
    if (const PathEntry* path = m_tool.path()) {
        for (const PathSpanEntry& span : path->spans)
            texts += tr("%1 – %2 %3 · %4")
                         .arg(lengthText(m_tool, span.from), lengthText(m_tool, span.to), unitOf(m_tool),
                              m_tool.spanText(span));
    }
    m_spans->fill(texts);
}

void PathPanel::fillObstacles()
{
    QStringList texts;
    if (const PathEntry* path = m_tool.path()) {
        for (const ObstacleEntry& obstacle : path->obstacles) {
            const auto number = texts.size() + 1;
            texts += obstacle.isDisc() ? tr("%1 · disc, radius %2 %3")
                                             .arg(number)
                                             .arg(lengthText(m_tool, obstacle.radius), unitOf(m_tool))
                                       : tr("%1 · polygon, %n corner(s)", nullptr,
                                            static_cast<int>(obstacle.corners.size()))
                                             .arg(number);
        }
    }
    m_obstacles->fill(texts);
}

void PathPanel::refreshSelection()
{
    const PathPart& part = m_tool.editor().selected();
    const bool isSpan = part.kind == PathPart::Kind::StretchStart || part.kind == PathPart::Kind::StretchEnd;
    const bool isObstacle =
        part.kind == PathPart::Kind::Obstacle || part.kind == PathPart::Kind::ObstacleCorner;
    m_spans->showRow(isSpan ? part.index : -1);
    m_obstacles->showRow(isObstacle ? part.index : -1);
    m_span->showSpan(isSpan ? part.index : -1);
    m_obstacle->showObstacle(isObstacle ? part.index : -1);
}

} // namespace quadrille

#include "moc_pathpanel.cpp"

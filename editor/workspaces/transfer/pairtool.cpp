// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/transfer/pairtool.h"

#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/transfer/transferworkspace.h"
#include "editor/workspaces/view/sceneview.h"
#include "widgets/theme/theme.h"

#include <QAction>
#include <QMenu>
#include <cmath>

namespace quadrille {

PairTool::PairTool(CurrentTransfer& transfer, QObject* parent)
    : QObject(parent)
    , m_transfer(transfer)
    , m_editor(new widgets::SurfacePairEditor(transfer.view().viewport(), this))
{
    makeActions();
    connectEditor();
    SceneView& view = transfer.view();
    view.viewport().setViewTool(m_editor);
    connect(&transfer, &CurrentTransfer::changed, this, &PairTool::refresh);
    connect(&transfer, &CurrentTransfer::resultChanged, this, &PairTool::refresh);
    connect(&transfer, &CurrentTransfer::selectionChanged, this, [this] {
        m_editor->setSelected(m_transfer.selected());
        refreshActions();
    });
    // Pairs would cover what plays.
    connect(&view.player(), &Player::playingChanged, this,
            [this](bool plays) { m_editor->setActive(m_isActive && !plays); });
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &PairTool::refresh);
    retranslates(&view, [this] { refresh(); });
}

void PairTool::connectEditor()
{
    using Editor = widgets::SurfacePairEditor;
    connect(m_editor, &Editor::pairRequested, this, [this](std::uint32_t first, std::uint32_t second) {
        const bool isFree = m_transfer.addPair({TriangleIndex(first), TriangleIndex(second)});
        tell(isFree ? QString() : tr("This triangle of the body has a pair already."));
    });
    connect(m_editor, &Editor::moveRequested, this,
            [this](int pair, int side, std::uint32_t triangle, bool isCommitted) {
                m_transfer.movePair(pair, side, triangle,
                                    isCommitted ? EditPhase::Final : EditPhase::Dragging);
            });
    connect(m_editor, &Editor::removalRequested, this, [this](int pair) { m_transfer.removePair(pair); });
    connect(m_editor, &Editor::selectionChanged, &m_transfer, &CurrentTransfer::select);
    connect(m_editor, &Editor::begunChanged, this, [this] { tell({}); });
    connect(m_editor, &Editor::counterpartRequested, this, &PairTool::addCounterpart);
    connect(m_editor, &Editor::contextMenuRequested, this, [this](int /*pair*/, const QPoint& place) {
        QMenu menu;
        menu.setObjectName(QStringLiteral("pairMenu"));
        ActionRegistry& actions = m_transfer.context().actions;
        for (const char* id : {"transfer.mirror", "transfer.removePair"})
            menu.addAction(actions.action(QLatin1String(id)));
        menu.exec(place);
    });
}

void PairTool::makeActions()
{
    const auto group = [] { return tr("Transfer"); };
    ActionRegistry& actions = m_transfer.context().actions;
    actions.add({"transfer.propose",
                 group,
                 [] { return tr("&Propose pairs"); },
                 [] {
                     return tr(
                         "Exchanges all pairs for ones that are found by laying the template onto the body");
                 },
                 "parts",
                 {}},
                [this] { propose(); });
    actions.add({"transfer.mirror",
                 group,
                 [] { return tr("&Mirror the pair"); },
                 [] { return tr("Adds the same pair on the other side of both bodies"); },
                 "mirror",
                 {}},
                [this] {
                    const bool isDone = m_transfer.mirrorPair(m_transfer.selected());
                    tell(isDone ? QString()
                                : tr("The other side has this pair already, or nothing tells where it is."));
                });
    actions.add({"transfer.mirrorAll",
                 group,
                 [] { return tr("Mirror &all pairs"); },
                 [] { return tr("Adds each pair on the other side as well, where that has none"); },
                 "exchange",
                 {}},
                [this] { mirrorAll(); });
    actions.add({"transfer.removePair",
                 group,
                 [] { return tr("&Remove the pair"); },
                 [] { return tr("Removes the selected pair"); },
                 "delete",
                 {}},
                [this] { m_transfer.removePair(m_transfer.selected()); });
}

void PairTool::setActive(bool active)
{
    m_isActive = active;
    m_editor->setActive(active && !m_transfer.view().player().isPlaying());
}

/// An entry without pairs has them proposed whenever it is computed; these are shown and can be edited.
void PairTool::propose()
{
    m_transfer.select(-1);
    m_transfer.setPairs(tr("Propose pairs"), {});
}

/// In a job: of a large scan each pair takes some milliseconds.
void PairTool::mirrorAll()
{
    const TransferPreviewPointer preview = m_transfer.preview();
    if (preview == nullptr || !preview->templatePlaces || !preview->targetPlaces)
        return;
    const std::vector<TrianglePair> pairs = m_transfer.plainPairs();
    m_transfer.context().jobs.start(
        {.name = tr("Mirroring pairs"),
         .receiver = this,
         .stillStands = [this, pairs] { return m_transfer.plainPairs() == pairs; },
         .background = true},
        [pairs, preview](const Progress& progress) {
            return withMirroredPairs(pairs, *preview->templatePlaces, *preview->targetPlaces, progress);
        },
        [this, before = pairs.size()](std::vector<TrianglePair> all) {
            const auto added = static_cast<int>(all.size() - before);
            if (added > 0)
                m_transfer.setPairs(tr("Mirror all pairs"), std::move(all));
            tell(tr("%n pair(s) were added.", nullptr, added));
        });
}

void PairTool::addCounterpart()
{
    const auto begun = m_editor->begun();
    if (!begun)
        return;
    const auto found = m_transfer.counterpart(begun->side, begun->triangle);
    if (!found) {
        tell(tr("Nothing tells which triangle of the other body belongs to it: click on it."));
        return;
    }
    m_editor->giveUpBegun();
    const TrianglePair pair = begun->side == 0
                                  ? TrianglePair{TriangleIndex(begun->triangle), TriangleIndex(*found)}
                                  : TrianglePair{TriangleIndex(*found), TriangleIndex(begun->triangle)};
    const bool isFree = m_transfer.addPair(pair);
    tell(isFree ? QString() : tr("This triangle of the body has a pair already."));
}

void PairTool::tell(const QString& text)
{
    m_told = text;
    showHint();
}

void PairTool::showHint()
{
    const auto& begun = m_editor->begun();
    if (!begun)
        m_editor->setHint(m_told);
    else if (begun->side == 0)
        m_editor->setHint(
            tr("Now click on the same place of the body; Return proposes one, Escape gives up."));
    else
        m_editor->setHint(
            tr("Now click on the same place of the template; Return proposes one, Escape gives up."));
}

void PairTool::refresh()
{
    ClipScene& scene = m_transfer.view().scene();
    m_editor->setFigures(scene.figureOf(TransferWorkspace::templateName()),
                         scene.figureOf(TransferWorkspace::targetName()));
    std::vector<widgets::SurfacePair> shown;
    int number = 0;
    for (const ProposedPair& each : m_transfer.pairs()) {
        const auto region = m_transfer.regionOf(each.pair);
        ++number;
        shown.push_back({.triangles = {static_cast<std::uint32_t>(each.pair.onTemplate.value),
                                       static_cast<std::uint32_t>(each.pair.onTarget.value)},
                         .color = widgets::Theme::categorical(region ? static_cast<int>(*region) : number),
                         .isDoubtful = !std::isnan(each.quality) && each.quality < doubtfulLikeness,
                         .name = region ? tr("%1: %2").arg(number).arg(CurrentTransfer::regionName(*region))
                                        : QString::number(number)});
    }
    m_editor->setPairs(std::move(shown));
    showHint();
    refreshActions();
}

void PairTool::refreshActions()
{
    ActionRegistry& actions = m_transfer.context().actions;
    const TransferPreviewPointer preview = m_transfer.preview();
    const bool hasPlaces = preview != nullptr && preview->templatePlaces && preview->targetPlaces;
    const bool isSelected = m_transfer.selected() >= 0;
    actions.action(QStringLiteral("transfer.propose"))
        ->setEnabled(m_transfer.entry() != nullptr && !m_transfer.arePairsProposed());
    actions.action(QStringLiteral("transfer.mirror"))->setEnabled(isSelected && hasPlaces);
    actions.action(QStringLiteral("transfer.mirrorAll"))
        ->setEnabled(hasPlaces && !m_transfer.pairs().empty());
    actions.action(QStringLiteral("transfer.removePair"))->setEnabled(isSelected);
}

} // namespace quadrille

#include "moc_pairtool.cpp"

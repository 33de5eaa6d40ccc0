// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The actions of the workspace.
#include "editor/context/editorcontext.h"
#include "editor/workspaces/graph/graphbar.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "editor/workspaces/graph/graphmap.h"
#include "editor/workspaces/graph/graphtablefiles.h"
#include "editor/workspaces/graph/graphworkspace.h"
#include "editor/workspaces/graph/pairpreview.h"
#include "editor/workspaces/graph/transitionspeeds.h"
#include "model/project/media/projectguard.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/graph/logslider.h"
#include "widgets/graph/matrixview.h"

#include <QActionGroup>
#include <QDir>
#include <QFileDialog>
#include <QTabWidget>
#include <algorithm>

namespace quadrille {

namespace {

constexpr double alphaStep = 1.25;

} // namespace

void GraphWorkspace::makeActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto group = [] { return tr("Graph"); };
    actions.add({"graph.compute",
                 group,
                 [] { return tr("&Compute the graph"); },
                 [] { return tr("Finds every transition between the frames of a character"); },
                 "refresh",
                 {QKeySequence(Qt::CTRL | Qt::Key_G)}},
                [this] { m_context.graphs.ask(m_bar->character()); });
    actions.add({"graph.stop",
                 group,
                 [] { return tr("S&top computing"); },
                 [] { return tr("Leaves the graph as it was"); },
                 "stop",
                 {}},
                [this] { m_context.graphs.stop(m_bar->character()); });
    actions.add({"graph.play",
                 group,
                 [] { return tr("&Play the transition"); },
                 [] { return tr("Blends the chosen transition and plays it with some frames around it"); },
                 "play",
                 {QKeySequence(Qt::SHIFT | Qt::Key_Space)}},
                [this] { activate(*m_chosen); });
    actions.add({"graph.frames",
                 group,
                 [] { return tr("Show &both frames"); },
                 [] { return tr("Shows where the chosen transition leaves and where it arrives"); },
                 "compare",
                 {}},
                [this] { showFrames(*m_chosen); });
    actions.addToggle({"graph.gentle",
                       group,
                       [] { return tr("Blend &gently"); },
                       [] { return tr("Keeps speeds smooth and standing feet in place, as animations can"); },
                       "contact",
                       {}},
                      false, [this](bool on) {
                          m_preview->setGentle(on);
                          m_speeds->setGentle(on);
                      });
    actions.add({"graph.alphaDown",
                 group,
                 [] { return tr("&Lower α"); },
                 [] { return tr("Lets the graphs prefer little deformation"); },
                 {},
                 {QKeySequence(Qt::Key_BracketLeft)}},
                [this] { stepAlpha(1 / alphaStep); });
    actions.add({"graph.alphaUp",
                 group,
                 [] { return tr("&Raise α"); },
                 [] { return tr("Lets the graphs prefer short ways"); },
                 {},
                 {QKeySequence(Qt::Key_BracketRight)}},
                [this] { stepAlpha(alphaStep); });
    actions.add({"graph.saveTables",
                 group,
                 [] { return tr("&Save tables…"); },
                 [] { return tr("Edges, statistics and components of both graphs as CSV files"); },
                 "save",
                 {}},
                [this] { saveTables(); });
    makeMenuActions();
    makeShowingActions();
}

void GraphWorkspace::makeModes()
{
    ActionRegistry& actions = m_context.actions;
    const auto group = [] { return tr("Graph"); };
    auto* modes = new QActionGroup(this);
    const auto mode = [&](const QString& id, ActionRegistry::Text text, ActionRegistry::Text tip,
                          const QString& icon, bool checked, GraphMap::Mode shown) {
        modes->addAction(actions.addToggle({id, group, std::move(text), std::move(tip), icon, {}}, checked,
                                           [this, shown](bool on) {
                                               if (on)
                                                   m_map->setMode(shown);
                                           }));
    };
    mode(
        "graph.matrix", [] { return tr("Show costs as a &matrix"); },
        [] { return tr("Each cell is a transition from the frame of its row to that of its column"); },
        "matrix", true, GraphMap::Mode::Matrix);
    mode(
        "graph.arcs", [] { return tr("Show edges as &arcs"); },
        [] { return tr("The Essential graph above the sequences, the motion graph below"); }, "arcs", false,
        GraphMap::Mode::Arcs);
    mode(
        "graph.takes", [] { return tr("Show ta&kes and their transitions"); },
        [] { return tr("Each take is a node; arrows count the transitions from one to another"); }, "takes",
        false, GraphMap::Mode::Takes);
}

void GraphWorkspace::makeShowingActions()
{
    makeModes();
    ActionRegistry& actions = m_context.actions;
    const auto group = [] { return tr("Graph"); };
    const auto showEdges = [this](bool) {
        m_map->setEdgesVisible(m_context.actions.action("graph.essentialEdges")->isChecked(),
                               m_context.actions.action("graph.motionEdges")->isChecked());
    };
    // Both are made before either is read.
    QAction* essential =
        actions.addToggle({"graph.essentialEdges",
                           group,
                           [] { return tr("&Essential graph on the matrix"); },
                           [] { return tr("Marks transitions that no cheaper way can replace with rings"); },
                           "essential",
                           {}},
                          true, [](bool) { /* told below, with the other */ });
    QAction* motion =
        actions.addToggle({"graph.motionEdges",
                           group,
                           [] { return tr("M&otion graph on the matrix"); },
                           [] { return tr("Marks transitions of locally least cost with diamonds"); },
                           "motiongraph",
                           {}},
                          false, [](bool) { /* as above */ });
    for (QAction* action : {essential, motion})
        connect(action, &QAction::toggled, this, showEdges);
    m_map->setEdgesVisible(true, false);
    actions.add({"graph.fit",
                 group,
                 [] { return tr("Show the &whole matrix"); },
                 [] { return tr("Zooms out until all frames show"); },
                 "frameall",
                 {}},
                [this] { m_map->matrix().fit(); });
    m_map->addTools({actions.action("graph.matrix"), actions.action("graph.arcs"),
                     actions.action("graph.takes"), nullptr, essential, motion, actions.action("graph.fit")});
    const auto tab = [&](const QString& id, ActionRegistry::Text text, ActionRegistry::Text tip, int index) {
        actions.add({id, group, std::move(text), std::move(tip), {}, {}}, [this, index] {
            m_tabs->setCurrentIndex(index);
            for (QWidget* each = m_tabs; each != nullptr && !each->isWindow(); each = each->parentWidget())
                each->show();
            m_tabs->currentWidget()->setFocus();
        });
    };
    tab(
        "graph.why", [] { return tr("W&hy this transition"); },
        [] { return tr("Its cost in parts, and what could be taken instead"); }, 0);
    tab(
        "graph.charts", [] { return tr("Charts over α"); },
        [] { return tr("Density, edges and mean cost of both graphs"); }, 1);
    tab(
        "graph.gaps", [] { return tr("Gaps of the &graphs"); },
        [] { return tr("Frames that walks do not reach, and what would help"); }, 2);
    tab(
        "graph.settings", [] { return tr("Graph sett&ings"); },
        [] { return tr("How poses are compared and which transitions are sought"); }, 3);
}

void GraphWorkspace::updateActions()
{
    const auto* resultState = m_context.graphs.resultState(m_bar->character());
    const bool computes = resultState != nullptr && resultState->phase == ResultPhase::Computing;
    const bool isThere = m_explorer->character() != nullptr;
    const auto enable = [this](const char* id, bool on) { m_context.actions.action(id)->setEnabled(on); };
    enable("graph.compute", resultState != nullptr && resultState->phase != ResultPhase::Ready && !computes);
    enable("graph.stop", computes);
    enable("graph.play", isThere && m_chosen.has_value());
    enable("graph.frames", isThere && m_chosen.has_value());
    enable("graph.copyFrames", isThere && m_chosen.has_value());
    enable("graph.saveTables", isThere && m_explorer->measured() != nullptr);
    for (const char* id : {"graph.alphaDown", "graph.alphaUp"})
        enable(id, resultState != nullptr);
}

void GraphWorkspace::stepAlpha(double factor)
{
    m_bar->editAlpha(
        std::clamp(m_bar->alpha().value() * factor, GraphBar::leastAlpha, GraphBar::greatestAlpha), true);
}

void GraphWorkspace::saveTables()
{
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the tables"));
    if (folder.isEmpty())
        return;
    m_context.jobs.start(
        {.name = tr("Saving tables"), .receiver = this},
        [opened = m_explorer->character(), measured = m_explorer->measured(),
         comparison = m_explorer->comparison(), folder, project = m_context.document.snapshot(),
         projectFile = m_context.document.workingFile()](const Progress& progress) {
            const auto guard = projectGuard(project, projectFile, {.outside = true});
            const WrittenNote note(*guard, projectFile);
            return writeGraphTables(opened->graph, *measured, comparison, folder.toStdString(), *guard,
                                    progress);
        },
        [this, folder](const std::vector<std::filesystem::path>& files) {
            m_message->show(widgets::MessageStrip::Kind::Info,
                            tr("%n table(s) were saved in %1.", nullptr, static_cast<int>(files.size()))
                                .arg(QDir::toNativeSeparators(folder)));
            m_message->setAction({});
        });
}

} // namespace quadrille

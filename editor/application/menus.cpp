// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/menus.h"

#include "editor/application/editorcontext.h"
#include "editor/language/retranslate.h"

#include <QActionGroup>
#include <QMainWindow>
#include <QMenuBar>

namespace quadrille {

Menus::Menus(EditorContext& context, const QList<QAction*>& docks, QMainWindow& window)
    : QObject(&window), m_context(context), m_window(window)
{
    addMenu([] { return tr("&File"); },
            {"file.new", "file.open", "file.recent", "file.sample", "", "file.import", "file.importFolder",
             "file.export", "", "file.findMissing", "", "file.save", "file.saveAs", "", "file.quit"});
    addMenu([] { return tr("&Edit"); },
            {"edit.undo", "edit.redo", "", "edit.rename", "edit.duplicate", "edit.remove", "",
             "edit.trimStart", "edit.trimEnd", "edit.untrim", "", "edit.label", "edit.proposeContacts",
             "edit.clearContacts", "", "edit.preferences"});
    QMenu* view = addMenu([] { return tr("&View"); }, {"workspace.sequences",
                                                       "workspace.graph",
                                                       "workspace.animate",
                                                       "workspace.variations",
                                                       "",
                                                       "view.textured",
                                                       "view.clay",
                                                       "view.wire",
                                                       "",
                                                       "view.grid",
                                                       "view.trajectory",
                                                       "view.names",
                                                       "view.follow",
                                                       "view.ghosts",
                                                       "view.measure",
                                                       "view.copy",
                                                       "view.savePicture",
                                                       "",
                                                       "view.sideBySide",
                                                       "view.overlay",
                                                       "view.heatMap",
                                                       "",
                                                       "view.frame",
                                                       "view.frameAll",
                                                       "view.front",
                                                       "view.side",
                                                       "view.top",
                                                       "",
                                                       "theme.system",
                                                       "theme.light",
                                                       "theme.dark",
                                                       "",
                                                       "view.jobs"});
    view->addActions(docks);
    addMenu([] { return tr("&Graph"); }, {"graph.compute",
                                          "graph.stop",
                                          "",
                                          "graph.alphaDown",
                                          "graph.alphaUp",
                                          "",
                                          "graph.matrix",
                                          "graph.arcs",
                                          "graph.essentialEdges",
                                          "graph.motionEdges",
                                          "graph.fit",
                                          "",
                                          "graph.play",
                                          "graph.frames",
                                          "graph.gentle",
                                          "",
                                          "graph.why",
                                          "graph.charts",
                                          "graph.gaps",
                                          "graph.settings",
                                          "",
                                          "graph.saveTables"});
    addMenu([] { return tr("&Animate"); }, {"animate.new",
                                            "animate.duplicate",
                                            "",
                                            "animate.addKey",
                                            "animate.removeKey",
                                            "animate.previousKey",
                                            "animate.nextKey",
                                            "animate.addAction",
                                            "",
                                            "animate.camera.add",
                                            "animate.camera.replace",
                                            "animate.camera.remove",
                                            "animate.camera.look",
                                            "",
                                            "animate.sound.choose",
                                            "animate.sound.mute",
                                            "animate.sound.remove",
                                            "",
                                            "animate.path.draw",
                                            "animate.path.span",
                                            "animate.path.disc",
                                            "animate.path.polygon",
                                            "animate.path.reverse",
                                            "animate.path.close",
                                            "animate.path.remove",
                                            "animate.path.show",
                                            "animate.path.deviation",
                                            "",
                                            "animate.solve",
                                            "animate.stop",
                                            "",
                                            "junction.previous",
                                            "junction.next",
                                            "junction.play",
                                            "",
                                            "junction.ban",
                                            "junction.banNeighbours",
                                            "junction.choose",
                                            "junction.lock",
                                            "junction.lockSegment",
                                            "junction.forget",
                                            "",
                                            "animate.acceptWalk",
                                            "animate.releaseWalk",
                                            "",
                                            "report.copy",
                                            "report.save",
                                            "report.saveFrames"});
    addMenu([] { return tr("Va&riations"); }, {"variations.new",
                                               "variations.duplicate",
                                               "",
                                               "variations.parts.propose",
                                               "variations.curve.draw",
                                               "variations.curve.second",
                                               "variations.curve.mirror",
                                               "variations.curve.shorten",
                                               "variations.curve.snap",
                                               "variations.parts.add",
                                               "variations.parts.remove",
                                               "variations.parts.show",
                                               "",
                                               "variations.learn",
                                               "variations.stop",
                                               "",
                                               "variations.addSet",
                                               "variations.removeSet",
                                               "variations.again",
                                               "",
                                               "variations.keep",
                                               "variations.discard",
                                               "variations.addSequence",
                                               "variations.export",
                                               "",
                                               "variations.original",
                                               "variations.confidence",
                                               "variations.frameLatent"});
    addMenu([] { return tr("&Playback"); },
            {"play.toggle", "", "play.previous", "play.next", "play.first", "play.last", "", "play.backwards",
             "play.pause", "play.forwards"});
    addLanguages();
    addMenu([] { return tr("&Help"); }, {"help.manual", "help.palette", "", "help.about"});
    m_window.addActions(context.actions.actions());
    retranslates(&window, [this] { retranslate(); });
}

QMenu* Menus::addMenu(std::function<QString()> title, const QStringList& actions)
{
    QMenu* menu = m_window.menuBar()->addMenu(QString());
    m_titles.emplace_back(menu, std::move(title));
    for (const QString& id : actions) {
        if (id.isEmpty())
            menu->addSeparator();
        else
            menu->addAction(m_context.actions.action(id));
    }
    return menu;
}

void Menus::addLanguages()
{
    QMenu* languages = addMenu([] { return tr("&Language"); }, {});
    auto* group = new QActionGroup(this);
    for (const Language& language : LanguageManager::languages()) {
        QAction* action = languages->addAction(language.name);
        action->setCheckable(true);
        action->setChecked(language.code == m_context.languages.language());
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, code = language.code] {
            m_context.settings.setLanguage(code);
            m_context.languages.setLanguage(code);
        });
    }
}

void Menus::retranslate()
{
    m_context.actions.retranslate();
    for (const auto& [menu, title] : m_titles)
        menu->setTitle(title());
}

} // namespace quadrille

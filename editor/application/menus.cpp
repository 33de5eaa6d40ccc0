// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/menus.h"

#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"

#include <QActionGroup>
#include <QMainWindow>
#include <QMenuBar>
#include <QUndoStack>

namespace quadrille {

Menus::Menus(EditorContext& context, QMainWindow& window)
    : QObject(&window), m_context(context), m_window(window)
{
    addFile();
    addView();
    addGraph();
    addAnimate();
    addVariations();
    addAppearance();
    addTransfer();
    addLive();
    addMenu("playbackMenu", [] { return tr("&Playback"); },
            {"play.toggle",
             "",
             "play.previous",
             "play.next",
             "play.first",
             "play.last",
             "",
             "play.backwards",
             "play.pause",
             "play.forwards",
             "",
             "play.andReturn",
             "play.loopStart",
             "play.loopEnd",
             "play.loopAll",
             "play.backAndForth",
             "",
             "play.seconds",
             "",
             "note.write",
             "note.previous",
             "note.next"});
    addMenu("helpMenu", [] { return tr("&Help"); },
            {"help.manual", "help.here", "help.palette", "", "help.about"});
    // What belongs to one part of the window is a shortcut of that part alone.
    for (QAction* action : context.actions.actions())
        if (action->shortcutContext() != Qt::WidgetWithChildrenShortcut)
            m_window.addAction(action);
    retranslates(&window, [this] { retranslate(); });
}

void Menus::addFile()
{
    addMenu("fileMenu", [] { return tr("&File"); },
            {"file.new", "file.open", "file.recent", "file.sample", "file.close", "", "file.import",
             "file.importFolder", "file.findMissing", "file.resultFolder", "", "file.save", "file.saveAs", "",
             "file.export", "", "file.quit"});
    QMenu* edit = addMenu("editMenu", [] { return tr("&Edit"); },
                          {"edit.undo", "edit.redo", "", "edit.rename", "edit.duplicate", "edit.remove",
                           "edit.properties", ""});
    addSubmenu(*edit, "takeMenu", [] { return tr("&Take"); },
               {"edit.trimStart", "edit.trimEnd", "edit.untrim", "", "edit.label", "edit.labelTakes",
                "edit.proposeContacts", "edit.clearContacts"});
    fill(*edit, {"", "edit.preferences"});
    // While it is open it says what is undone.
    const QUndoStack* steps = m_context.document.undoStack();
    nameWhileOpen(*edit, "edit.undo", [steps] { return steps->undoText(); });
    nameWhileOpen(*edit, "edit.redo", [steps] { return steps->redoText(); });
}

void Menus::nameWhileOpen(QMenu& menu, const char* id, std::function<QString()> what)
{
    QAction* action = m_context.actions.action(QLatin1String(id));
    connect(&menu, &QMenu::aboutToShow, action, [action, what = std::move(what)] {
        const QString step = what().replace(QLatin1Char('&'), QLatin1String("&&"));
        action->setProperty("plainText", action->text());
        //: an action and what it is about, as “Undo: Rename “walk””
        action->setText(step.isEmpty() ? action->text() : tr("%1: %2").arg(action->text(), step));
    });
    connect(&menu, &QMenu::aboutToHide, action,
            [action] { action->setText(action->property("plainText").toString()); });
}

void Menus::addView()
{
    m_view = addMenu("viewMenu", [] { return tr("&View"); }, {});
    addSubmenu(*m_view, "workspaceMenu", [] { return tr("Wor&kspace"); },
               {"workspace.sequences", "workspace.graph", "workspace.animate", "workspace.variations",
                "workspace.appearance", "workspace.transfer", "workspace.live"});
    fill(*m_view, {""});
    addSubmenu(*m_view, "shadingMenu", [] { return tr("&Shading"); },
               {"view.textured", "view.clay", "view.wire"});
    addSubmenu(*m_view, "showMenu", [] { return tr("Sho&w"); },
               {"view.grid", "view.shadow", "view.trajectory", "view.names", "", "view.ghosts",
                "view.pinGhost", "view.unpinGhosts"});
    addSubmenu(*m_view, "cameraMenu", [] { return tr("&Camera"); },
               {"view.frame", "view.frameAll", "view.follow", "", "view.front", "view.side", "view.top", "",
                "view.zoomIn", "view.zoomOut"});
    addSubmenu(*m_view, "compareMenu", [] { return tr("Com&pare"); },
               {"view.sideBySide", "view.overlay", "view.heatMap"});
    fill(*m_view, {"view.measure"});
    addSubmenu(*m_view, "pictureMenu", [] { return tr("P&icture"); }, {"view.copy", "view.savePicture"});
    m_view->addSeparator();
    addSubmenu(*m_view, "themeMenu", [] { return tr("&Theme"); },
               {"theme.system", "theme.light", "theme.dark"});
    addLanguages();
    fill(*m_view, {"view.fullScreen", "", "view.jobs"});
}

void Menus::addGraph()
{
    QMenu* graph = addMenu("graphMenu", [] { return tr("&Graph"); },
                           {"graph.compute", "graph.stop", "", "graph.alphaDown", "graph.alphaUp", ""});
    addSubmenu(*graph, "graphShowMenu", [] { return tr("Sho&w"); },
               {"graph.matrix", "graph.arcs", "graph.takes", "", "graph.essentialEdges", "graph.motionEdges",
                "", "graph.fit"});
    fill(*graph, {"graph.play", "graph.frames", "graph.copyFrames", "graph.gentle", "", "graph.why",
                  "graph.charts", "graph.gaps", "graph.settings", "", "graph.saveTables", ""});
    addSubmenu(*graph, "evaluationsMenu", [] { return tr("E&valuations"); },
               {"evaluations.add", "evaluations.show", "", "evaluations.compute", "evaluations.stop", "",
                "evaluations.copy", "evaluations.save"});
}

void Menus::addAnimate()
{
    QMenu* animate = addMenu("animateMenu", [] { return tr("&Animate"); },
                             {"animate.new", "animate.duplicate", "", "animate.solve", "animate.stop", ""});
    addSubmenu(*animate, "pathActionsMenu", [] { return tr("&Path"); },
               {"animate.path.draw", "animate.path.span", "animate.path.disc", "animate.path.polygon", "",
                "animate.path.reverse", "animate.path.close", "animate.path.remove", "", "animate.path.show",
                "animate.path.deviation"});
    addSubmenu(*animate, "keysMenu", [] { return tr("&Keys and storyboard"); },
               {"animate.addKey", "animate.removeKey", "animate.previousKey", "animate.nextKey", "",
                "animate.addAction"});
    addSubmenu(
        *animate, "cameraKeysMenu", [] { return tr("&Camera"); },
        {"animate.camera.add", "animate.camera.replace", "animate.camera.remove", "animate.camera.look"});
    addSubmenu(*animate, "soundMenu", [] { return tr("&Sound"); },
               {"animate.sound.choose", "animate.sound.mute", "animate.sound.remove"});
    addSubmenu(*animate, "transitionsMenu", [] { return tr("&Transitions"); },
               {"junction.previous", "junction.next", "junction.play", "", "junction.choose", "junction.ban",
                "junction.banNeighbours", "", "junction.lock", "junction.lockSegment", "junction.forget"});
    fill(*animate, {"", "animate.acceptWalk", "animate.releaseWalk", ""});
    addSubmenu(*animate, "reportMenu", [] { return tr("&Report"); },
               {"report.copy", "report.save", "report.saveFrames"});
}

void Menus::addVariations()
{
    QMenu* variations =
        addMenu("variationsMenu", [] { return tr("Va&riations"); },
                {"variations.new", "variations.duplicate", "", "variations.learn", "variations.stop", ""});
    addSubmenu(*variations, "partsMenu", [] { return tr("&Parts of the body"); },
               {"variations.parts.propose", "variations.parts.add", "variations.parts.remove",
                "variations.parts.show", "", "variations.curve.draw", "variations.curve.second",
                "variations.curve.mirror", "variations.curve.shorten", "variations.curve.snap"});
    addSubmenu(*variations, "samplesMenu", [] { return tr("&Samples"); },
               {"variations.addSet", "variations.removeSet", "variations.again", "", "variations.keep",
                "variations.discard", "variations.addSequence"});
    addSubmenu(*variations, "latentMenu", [] { return tr("&Latent space"); },
               {"variations.original", "variations.confidence", "variations.frameLatent"});
    fill(*variations, {"", "variations.export"});
}

void Menus::addAppearance()
{
    QMenu* appearance =
        addMenu("appearanceMenu", [] { return tr("Appeara&nce"); },
                {"appearance.new", "appearance.duplicate", "", "appearance.build", "appearance.stop", ""});
    addSubmenu(*appearance, "completionsMenu", [] { return tr("&Completions"); },
               {"appearance.paint", "appearance.clearMask", "", "appearance.addCompletion",
                "appearance.removeCompletion", "", "appearance.complete"});
    addSubmenu(*appearance, "textureModeMenu", [] { return tr("Te&xture"); },
               {"appearance.first", "appearance.second", "appearance.difference", "appearance.absolute",
                "appearance.sideBySide", "appearance.swipe", "", "appearance.edges", "appearance.fit"});
}

void Menus::addTransfer()
{
    QMenu* transfer = addMenu(
        "transferMenu", [] { return tr("&Transfer"); },
        {"transfer.new", "transfer.duplicate", "", "transfer.reference", "transfer.takeReference", ""});
    addSubmenu(*transfer, "pairsMenu", [] { return tr("&Pairs"); },
               {"transfer.propose", "transfer.mirror", "transfer.mirrorAll", "transfer.removePair"});
    fill(*transfer, {"", "transfer.addSequence", "transfer.export", "", "projection.new"});
}

void Menus::addLive()
{
    addMenu("liveMenu", [] { return tr("&Live"); },
            {"live.run", "live.record", "live.restart", "", "motionSpaces.new", "", "live.addSequence",
             "live.export"});
}

void Menus::addLanguages()
{
    QMenu* languages = addSubmenu(*m_view, "languageMenu", [] { return tr("&Language"); });
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

QMenu* Menus::addMenu(const char* name, std::function<QString()> title, const QStringList& actions)
{
    QMenu* menu = m_window.menuBar()->addMenu(QString());
    menu->setObjectName(QLatin1String(name));
    m_titles.emplace_back(menu, std::move(title));
    fill(*menu, actions);
    return menu;
}

QMenu* Menus::addSubmenu(QMenu& menu, const char* name, std::function<QString()> title,
                         const QStringList& actions)
{
    QMenu* submenu = menu.addMenu(QString());
    submenu->setObjectName(QLatin1String(name));
    submenu->setTitle(title());
    m_titles.emplace_back(submenu, std::move(title));
    fill(*submenu, actions);
    return submenu;
}

void Menus::fill(QMenu& menu, const QStringList& actions)
{
    for (const QString& id : actions) {
        if (id.isEmpty())
            menu.addSeparator();
        else
            menu.addAction(m_context.actions.action(id));
    }
}

void Menus::retranslate()
{
    m_context.actions.retranslate();
    for (const auto& [menu, title] : m_titles)
        menu->setTitle(title());
}

} // namespace quadrille

#include "moc_menus.cpp"

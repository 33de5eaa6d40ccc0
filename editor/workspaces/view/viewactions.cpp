// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/view/viewactions.h"

#include "editor/context/editorcontext.h"
#include "editor/workspaces/view/sceneview.h"
#include "editor/workspaces/view/timelineactions.h"
#include "editor/workspaces/view/viewtools.h"

#include <QActionGroup>
#include <array>
#include <utility>

namespace quadrille {

namespace {

using widgets::Shading;
using Layout = widgets::Viewport::Layout;
using Tool = widgets::Viewport::Tool;

constexpr std::array shadings{std::pair{"view.textured", Shading::Textured},
                              std::pair{"view.clay", Shading::Clay},
                              std::pair{"view.wire", Shading::Wireframe}};

} // namespace

ViewActions::ViewActions(EditorContext& context, QObject* parent)
    : QObject(parent)
    , m_context(context)
    , m_timeline(new TimelineActions(
          context, [this] { return view(); }, this))
{
    makePlaybackActions();
    makeShadingActions();
    makeToggles();
    makeCameraActions();
    makeComparingActions();
    makeGhostActions();
}

void ViewActions::setView(SceneView* view)
{
    if (view == m_view)
        return;
    if (m_view != nullptr) {
        m_view->player().pause();
        m_view->disconnect(this);
        m_view->player().disconnect(this);
        m_view->scene().ghosts().disconnect(this);
        m_view->viewport().disconnect(this);
    }
    m_view = view;
    if (view == nullptr)
        return;
    apply();
    followPins();
    connect(&view->scene().ghosts(), &SceneGhosts::pinnedChanged, this, &ViewActions::followPins);
    connect(&view->player(), &Player::frameChanged, this, &ViewActions::followPins);
    connect(view, &SceneView::coloredByToolChanged, this, &ViewActions::followColors);
    connect(&view->viewport(), &widgets::Viewport::toolChanged, this, [this](Tool tool) {
        m_context.actions.action("view.measure")->setChecked(tool == Tool::Measure);
    });
    connect(view, &SceneView::sceneChanged, this, &ViewActions::applyComparing);
    connect(view, &SceneView::clayRequested, this,
            [this] { m_context.actions.action("view.clay")->trigger(); });
}

bool ViewActions::isOn(const char* id) const
{
    return m_context.actions.action(QLatin1String(id))->isChecked();
}

void ViewActions::apply()
{
    widgets::Viewport& viewport = m_view->viewport();
    followColors();
    applyComparing();
    viewport.setGridVisible(isOn("view.grid"));
    viewport.setShadowsVisible(isOn("view.shadow"));
    viewport.setTrajectoriesVisible(isOn("view.trajectory"));
    viewport.setTool(isOn("view.measure") ? Tool::Measure : Tool::Navigate);
    viewport.setLayoutMode(isOn("view.overlay") ? Layout::Overlay : Layout::SideBySide);
    m_view->setNamesShown(isOn("view.names"));
    m_view->setGhostsShown(isOn("view.ghosts"));
    m_view->setFollowing(isOn("view.follow"));
    m_timeline->follow();
}

/// Tools for several clips are there where several are shown.
void ViewActions::applyComparing()
{
    m_view->tools().setComparing(m_view->scene().isComparing());
}

void ViewActions::applyShading()
{
    for (const auto& [id, shading] : shadings) {
        if (isOn(id))
            m_view->viewport().setShading(shading);
    }
}

/// While a tool colours the view, none of the usual ways is on; one that is chosen then counts.
void ViewActions::followColors()
{
    using Policy = QActionGroup::ExclusionPolicy;
    if (m_view->isColoredByTool()) {
        if (QAction* before = m_shading->checkedAction()) {
            m_shadingBefore = before;
            m_shading->setExclusionPolicy(Policy::ExclusiveOptional);
            before->setChecked(false);
        }
        return;
    }
    m_shading->setExclusionPolicy(Policy::Exclusive);
    if (m_shadingBefore && m_shading->checkedAction() == nullptr)
        m_shadingBefore->setChecked(true);
    m_shadingBefore.clear();
    applyShading();
}

void ViewActions::makePlaybackActions()
{
    // Steps and ends as the bar has them: a view may show something else than its player.
    ActionRegistry& actions = m_context.actions;
    const auto add = [this, &actions](const char* id, ActionRegistry::Text text, const char* icon,
                                      Qt::Key key, std::function<void(SceneView&)> run) {
        actions.add({QLatin1String(id),
                     [] { return tr("Playback"); },
                     std::move(text),
                     {},
                     QLatin1String(icon),
                     {key}},
                    [this, run = std::move(run)] {
                        if (m_view != nullptr)
                            run(*m_view);
                    });
    };
    add(
        "play.toggle", [] { return tr("&Play or pause"); }, "play", Qt::Key_Space,
        [](SceneView& view) { view.player().toggle(); });
    add(
        "play.previous", [] { return tr("P&revious frame"); }, "stepback", Qt::Key_Left,
        [](SceneView& view) { emit view.playback().stepRequested(-1); });
    add(
        "play.next", [] { return tr("&Next frame"); }, "step", Qt::Key_Right,
        [](SceneView& view) { emit view.playback().stepRequested(1); });
    add(
        "play.first", [] { return tr("&First frame"); }, "first", Qt::Key_Home,
        [](SceneView& view) { emit view.playback().firstRequested(); });
    add(
        "play.last", [] { return tr("&Last frame"); }, "last", Qt::Key_End,
        [](SceneView& view) { emit view.playback().lastRequested(); });
    add(
        "play.backwards", [] { return tr("Play &backwards, faster"); }, "stepback", Qt::Key_J,
        [](SceneView& view) { view.player().shuttle(-1); });
    add(
        "play.pause", [] { return tr("P&ause"); }, "pause", Qt::Key_K,
        [](SceneView& view) { view.player().pause(); });
    add(
        "play.forwards", [] { return tr("Play f&orwards, faster"); }, "step", Qt::Key_L,
        [](SceneView& view) { view.player().shuttle(1); });
}

void ViewActions::makeShadingActions()
{
    const std::array texts{ActionRegistry::Text([] { return tr("&Textured"); }),
                           ActionRegistry::Text([] { return tr("&Clay"); }),
                           ActionRegistry::Text([] { return tr("&Wireframe"); })};
    const auto view = [] { return tr("View"); };
    m_shading = new QActionGroup(this);
    for (std::size_t i = 0; i < shadings.size(); ++i) {
        const QString id = QLatin1String(shadings.at(i).first);
        m_shading->addAction(m_context.actions.addToggle(
            {id, view, texts.at(i), {}, id.section(QLatin1Char('.'), 1), {}}, i == 0, [this](bool on) {
                if (!on || m_view == nullptr)
                    return;
                m_view->setColoredByTool(false);
                applyShading();
            }));
    }
    m_shading->addAction(m_context.actions.addToggle(
        {"view.heatMap",
         view,
         [] { return tr("&Pose distance"); },
         [] { return tr("Colours two takes by how much each part of their poses differs"); },
         "scalar",
         {Qt::SHIFT | Qt::Key_D}},
        false, [](bool) { /* who compares poses listens to it */ }));
}

void ViewActions::makeToggles()
{
    // Steps and ends as the bar has them: a view may show something else than its player.
    ActionRegistry& actions = m_context.actions;
    const auto add = [this, &actions](const char* id, ActionRegistry::Text text, const char* icon,
                                      QList<QKeySequence> keys, bool on,
                                      std::function<void(SceneView&, bool)> run) {
        actions.addToggle({QLatin1String(id),
                           [] { return tr("View"); },
                           std::move(text),
                           {},
                           QLatin1String(icon),
                           std::move(keys)},
                          on, [this, run = std::move(run)](bool isNowOn) {
                              if (m_view != nullptr)
                                  run(*m_view, isNowOn);
                          });
    };
    add(
        "view.grid", [] { return tr("&Grid"); }, "grid", {Qt::Key_G}, true,
        [](SceneView& view, bool on) { view.viewport().setGridVisible(on); });
    add(
        "view.shadow", [] { return tr("Sha&dow"); }, "shadow", {}, true,
        [](SceneView& view, bool on) { view.viewport().setShadowsVisible(on); });
    add(
        "view.trajectory", [] { return tr("Trajector&y"); }, "trajectory", {}, true,
        [](SceneView& view, bool on) { view.viewport().setTrajectoriesVisible(on); });
    add(
        "view.names", [] { return tr("&Names"); }, "names", {}, true,
        [](SceneView& view, bool on) { view.setNamesShown(on); });
    add(
        "view.ghosts", [] { return tr("G&hosts"); }, "ghost", {Qt::Key_H}, false,
        [](SceneView& view, bool on) { view.setGhostsShown(on); });
    add(
        "view.measure", [] { return tr("&Measure"); }, "measure", {}, false,
        [](SceneView& view, bool on) { view.viewport().setTool(on ? Tool::Measure : Tool::Navigate); });
    add(
        "view.follow", [] { return tr("&Follow the character"); }, "follow", {}, false,
        [](SceneView& view, bool on) { view.setFollowing(on); });
}

void ViewActions::makeGhostActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto view = [] { return tr("View"); };
    actions.addToggle({"view.pinGhost",
                       view,
                       [] { return tr("&Pin this frame as a ghost"); },
                       [] { return tr("Keep the pose that is shown in the view, with its frame number"); },
                       "pin",
                       {Qt::CTRL | Qt::Key_H}},
                      false, [this](bool on) {
                          if (m_view != nullptr)
                              m_view->scene().setPinned(on);
                      });
    actions
        .add({"view.unpinGhosts",
              view,
              [] { return tr("&Remove all pinned ghosts"); },
              {},
              "unpin",
              {Qt::CTRL | Qt::SHIFT | Qt::Key_H}},
             [this] {
                 if (m_view != nullptr)
                     m_view->scene().ghosts().unpinAll();
             })
        ->setEnabled(false);
}

/// Whether the frame that is shown is pinned, and whether any is.
void ViewActions::followPins()
{
    const bool isPinned = m_view->scene().isPinned();
    QAction* pin = m_context.actions.action(QStringLiteral("view.pinGhost"));
    if (pin->isChecked() != isPinned) {
        // It is another frame, not another wish.
        const QSignalBlocker quiet(pin);
        pin->setChecked(isPinned);
    }
    m_context.actions.action(QStringLiteral("view.unpinGhosts"))
        ->setEnabled(m_view->scene().ghosts().hasPinned());
}

void ViewActions::makeCameraActions()
{
    // Steps and ends as the bar has them: a view may show something else than its player.
    ActionRegistry& actions = m_context.actions;
    const auto add = [this, &actions](const char* id, ActionRegistry::Text text, const char* icon,
                                      const QKeySequence& key, std::function<void(SceneView&)> run) {
        actions.add(
            {QLatin1String(id), [] { return tr("View"); }, std::move(text), {}, QLatin1String(icon), {key}},
            [this, run = std::move(run)] {
                if (m_view != nullptr)
                    run(*m_view);
            });
    };
    const auto look = [](widgets::StandardView side) {
        return [side](SceneView& view) { view.viewport().lookFrom(side); };
    };
    add(
        "view.frame", [] { return tr("Fra&me the selection"); }, "frame", Qt::Key_F,
        [](SceneView& view) { view.frameCurrent(); });
    add(
        "view.frameAll", [] { return tr("Frame &all"); }, "frameall", Qt::SHIFT | Qt::Key_F,
        [](SceneView& view) { view.viewport().frameAll(); });
    add(
        "view.front", [] { return tr("From the f&ront"); }, "viewfront", Qt::Key_1,
        look(widgets::StandardView::Front));
    add(
        "view.side", [] { return tr("From the &side"); }, "viewside", Qt::Key_3,
        look(widgets::StandardView::Right));
    add(
        "view.top", [] { return tr("From a&bove"); }, "viewtop", Qt::Key_7, look(widgets::StandardView::Top));
}

void ViewActions::makeComparingActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto view = [] { return tr("View"); };
    auto* layouts = new QActionGroup(this);
    const auto chooses = [this](Layout layout) {
        return [this, layout](bool on) {
            if (on && m_view != nullptr)
                m_view->setLayoutMode(layout);
        };
    };
    layouts->addAction(
        actions.addToggle({"view.sideBySide", view, [] { return tr("Side by s&ide"); }, {}, "sidebyside", {}},
                          true, chooses(Layout::SideBySide)));
    layouts->addAction(actions.addToggle({"view.overlay",
                                          view,
                                          [] { return tr("&Overlaid"); },
                                          [] { return tr("Overlaid, each in a colour of its own"); },
                                          "overlay",
                                          {}},
                                         false, chooses(Layout::Overlay)));
}

} // namespace quadrille

#include "moc_viewactions.cpp"

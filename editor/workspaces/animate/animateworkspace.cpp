// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/animateworkspace.h"

#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/animate/animationbar.h"
#include "editor/workspaces/animate/animationcamera.h"
#include "editor/workspaces/animate/animationsound.h"
#include "editor/workspaces/animate/animationtimeline.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/framekinds.h"
#include "editor/workspaces/animate/junctionpanel.h"
#include "editor/workspaces/animate/keysandstoryboard.h"
#include "editor/workspaces/animate/pathentries.h"
#include "editor/workspaces/animate/pathpanel.h"
#include "editor/workspaces/animate/pathresult.h"
#include "editor/workspaces/animate/pathtool.h"
#include "editor/workspaces/animate/postpanel.h"
#include "editor/workspaces/animate/reportpanel.h"
#include "editor/workspaces/animate/transitionpreview.h"
#include "editor/workspaces/sequences/posecomparison.h"
#include "model/project/results/openanimation.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/timeline/cliplegend.h"

#include <QVBoxLayout>
#include <utility>

namespace quadrille {

namespace {

ClipScene::Source sourceOf(const EditorContext& context, JunctionPanel* const& junctions)
{
    return {.clip = [&context, &junctions](const QString& name, bool) -> const MeshSequence* {
                if (name == TransitionPreview::name())
                    return junctions->preview().clip();
                const auto* resultState = context.animations.resultState(name);
                return resultState == nullptr || resultState->result == nullptr
                           ? nullptr
                           : &resultState->result->sequence;
            },
            .upAxis = [&context] { return context.media.upAxis(); },
            .ghostColor =
                [&context](const QString& name, std::int64_t frame) {
                    const auto result = context.animations.result(name);
                    const auto index = static_cast<std::size_t>(frame);
                    const bool isKnown = result && index < result->origins.size();
                    return widgets::frameKindColor(isKnown ? frameKindOf(result->origins[index])
                                                           : widgets::FrameKind::Captured);
                },
            .drawsWay = false,
            .section = Section::Animations};
}

} // namespace

AnimateWorkspace::AnimateWorkspace(EditorContext& context, QWidget* parent)
    : Workspace(parent)
    , m_context(context)
    , m_view(new SceneView(context, sourceOf(context, m_junctions), QStringLiteral("animate")))
    , m_animation(new CurrentAnimation(context, *m_view, this))
    , m_keysAndStoryboard(new KeysAndStoryboard(*m_animation, this))
    , m_path(new PathTool(*m_animation, this))
    , m_sound(new AnimationSound(*m_animation, this))
    , m_camera(new AnimationCamera(*m_animation, this))
{
    setObjectName(QStringLiteral("animateWorkspace"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(new AnimationBar(*m_animation));
    column->addWidget(m_view, 1);
    using widgets::FrameKind;
    m_view->addBelowTimeline(
        new widgets::ClipLegend({FrameKind::Captured, FrameKind::Varied, FrameKind::Transition}));
    connect(m_animation, &CurrentAnimation::changed, this, &AnimateWorkspace::followAnimations);
    connect(&context.animations, &AnimationResults::changed, this, &AnimateWorkspace::followResult);
    connect(&m_view->message(), &widgets::MessageStrip::actionTriggered, this,
            [this] { m_context.animations.retry(m_animation->name()); });
    for (Panel& panel : m_keysAndStoryboard->panels())
        m_panels.push_back(std::move(panel));
    new PathResult(*m_animation, this);
    m_panels.push_back({"pathDock", [] { return tr("Path"); }, new PathPanel(*m_path)});
    connect(&m_path->editor(), &widgets::PathEditor::modeChanged, this, &AnimateWorkspace::showState);
    m_comparison = new PoseComparison(context, m_view->viewport(), m_view->scene(), this);
    connect(m_comparison, &PoseComparison::changed, this, &AnimateWorkspace::showState);
    m_junctions = new JunctionPanel(*m_animation);
    connect(&m_junctions->preview(), &TransitionPreview::changed, this, &AnimateWorkspace::followPreview);
    connectJunctions();
    m_panels.push_back({"junctionDock", [] { return tr("Transitions"); }, m_junctions});
    retranslates(this, [this] { showState(); });
    m_panels.push_back({"finishDock", [] { return tr("Finish"); }, new PostPanel(*m_animation)});
    m_panels.push_back({"reportDock", [] { return tr("Report"); }, new ReportPanel(*m_animation)});
    followAnimations();
}

/// A transition is the same in the clip strip and in its panel.
void AnimateWorkspace::connectJunctions()
{
    AnimationTimeline& timeline = m_keysAndStoryboard->timeline();
    connect(&timeline, &AnimationTimeline::junctionSelected, m_junctions, [this](int junction) {
        if (junction >= 0)
            m_junctions->select(junction);
    });
    connect(m_junctions, &JunctionPanel::junctionSelected, &timeline, &AnimationTimeline::selectJunction);
    connect(&timeline, &AnimationTimeline::junctionActivated, m_junctions, [this](int junction) {
        showPanel(m_junctions);
        m_junctions->select(junction);
        m_context.actions.action(QStringLiteral("junction.play"))->trigger();
    });
}

std::vector<Workspace::Panel> AnimateWorkspace::panels()
{
    return m_panels;
}

QString AnimateWorkspace::shownClip() const
{
    return m_animation->entry() == nullptr ? QString() : QStringLiteral("animations/") + m_animation->name();
}

std::optional<NamedFrame> AnimateWorkspace::shownPose()
{
    const auto result = m_animation->result();
    const auto frame = static_cast<std::size_t>(player().frame().value);
    if (result == nullptr || frame >= result->origins.size())
        return std::nullopt;
    return result->character->graph.nameOf(result->origins[frame].nearest());
}

void AnimateWorkspace::setActive(bool active)
{
    m_isActive = active;
    followAnimations();
    // After the window has arranged the docks.
    if (active)
        QMetaObject::invokeMethod(m_keysAndStoryboard, &KeysAndStoryboard::fitDocks, Qt::QueuedConnection);
}

/// Animations are sought only while somebody looks.
void AnimateWorkspace::followAnimations()
{
    if (!m_isActive)
        return;
    const QStringList& names = m_context.selection.animations();
    m_context.animations.want(names);
    const bool isPreviewing = m_junctions->preview().clip() != nullptr;
    m_view->show(isPreviewing ? QStringList{TransitionPreview::name()} : names);
    m_view->setCurrent(m_animation->name());
    showState();
    frameOther();
}

/// An animation that has a path opens with it in view; later the view is the user's.
void AnimateWorkspace::frameOther()
{
    const QString before = std::exchange(m_framed, m_animation->name());
    const AnimationEntry* entry = m_animation->entry();
    // Who begins a path in a new animation draws where he looks.
    if (before == m_framed || entry == nullptr || findPath(*entry) == nullptr)
        return;
    // After the tools have put their marks into the view.
    QMetaObject::invokeMethod(
        this, [this] { viewport().frameAll(); }, Qt::QueuedConnection);
}

/// While another transition is looked for, what it would be like plays in the view.
void AnimateWorkspace::followPreview()
{
    const bool isPreviewing = m_junctions->preview().clip() != nullptr;
    if (isPreviewing && !m_frameBefore)
        m_frameBefore = player().frame();
    scene().update(TransitionPreview::name());
    m_view->setTimelineOffset(isPreviewing ? m_junctions->previewStart() : 0);
    followAnimations();
    if (!isPreviewing) {
        player().pause();
        player().setLooping(m_context.settings.loopsPlayback());
        if (const auto before = std::exchange(m_frameBefore, std::nullopt))
            player().goTo(before->value);
        return;
    }
    player().setLooping(true);
    player().goToStart();
    player().play();
}

void AnimateWorkspace::followResult(const QString& name)
{
    scene().update(name);
    if (name == m_animation->name())
        showState();
}

/// Says what is on its way, missing or went wrong, where it will be seen.
void AnimateWorkspace::showState()
{
    const auto* resultState = m_context.animations.resultState(m_animation->name());
    const AnimationEntry* entry = m_animation->entry();
    QString notice;
    if (m_context.document.project().sequences.empty())
        notice = tr("Import sequences first: animations are made from them.");
    else if (entry == nullptr)
        notice = tr("No animation yet.");
    else if (!entry->asksForSomething())
        notice = tr("Draw a path, drop poses onto the timeline, or line up takes in the storyboard.");
    else if (resultState != nullptr && resultState->result == nullptr &&
             resultState->phase == ResultPhase::Waiting)
        notice = tr("Computing the graph of transitions…");
    else if (resultState != nullptr && resultState->result == nullptr &&
             resultState->phase == ResultPhase::Computing)
        notice = tr("Seeking a walk…");
    if (m_path->editor().mode() != widgets::PathEditor::Mode::Edit)
        notice.clear();
    viewport().setNotice(notice);
    widgets::MessageStrip& message = m_view->message();
    if (resultState != nullptr && resultState->error) {
        const ErrorText text = describe(*resultState->error);
        message.show(widgets::MessageStrip::Kind::Error, text.placed(), text.remedy);
        message.setAction(tr("Try again"));
    } else if (m_junctions->preview().clip() != nullptr) {
        message.show(widgets::MessageStrip::Kind::Info, tr("This is what another transition would be like."),
                     tr("Return takes it; Escape goes back to the clip."));
        message.setAction({});
    } else if (const QString problem = m_comparison->problem(); !problem.isEmpty()) {
        message.show(widgets::MessageStrip::Kind::Warning, problem, m_comparison->remedy());
        message.setAction({});
    } else {
        message.clear();
    }
}

} // namespace quadrille

#include "moc_animateworkspace.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/variationsworkspace.h"

#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/panelfront.h"
#include "editor/workspaces/variations/bodypartspanel.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/latentpanel.h"
#include "editor/workspaces/variations/learningpanel.h"
#include "editor/workspaces/variations/movementpanel.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/variations/samplespanel.h"
#include "editor/workspaces/variations/variationbar.h"
#include "editor/workspaces/variations/warppanel.h"
#include "model/variation/movement.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/theme.h"

#include <QAction>
#include <QApplication>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

/// What a variation is called in the view.
QString nameOf(const DrawnVariation& drawn)
{
    return VariationsWorkspace::tr("Variation %1").arg(drawn.inSet);
}

/// The takes that the variations of a set are of: one, or those of its blend.
QStringList takesOfSet(const SamplesEntry& set)
{
    const AcrossSamplesEntry across = set.across.value_or(AcrossSamplesEntry());
    QStringList takes;
    for (const std::string& name : {set.of, set.to, across.of, across.to}) {
        if (!name.empty())
            takes += QString::fromStdString(name);
    }
    takes.removeDuplicates();
    return takes;
}

/// The frames of a take that are learned from, one cycle of a walk; nothing where that is not known.
std::optional<FrameRange> framesLearned(const CurrentVariation& variation, const QString& take)
{
    const auto movement = variation.movement();
    for (std::size_t t = 0; movement != nullptr && t < movement->capturedCount(); ++t) {
        if (movement->take(t).name == take.toStdString())
            return movement->take(t).warp.frames;
    }
    return std::nullopt;
}

} // namespace

VariationsWorkspace::VariationsWorkspace(EditorContext& context, QWidget* parent)
    : Workspace(parent)
    , m_context(context)
    , m_view(new SceneView(context, source(), QStringLiteral("variations")))
    , m_variation(new CurrentVariation(context, *m_view, this))
    , m_parts(new PartCurveTool(*m_variation, this))
{
    setObjectName(QStringLiteral("variationsWorkspace"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(new VariationBar(*m_variation));
    column->addWidget(m_view, 1);
    makeActions();
    makePanels();
    connect(m_variation, &CurrentVariation::changed, this, &VariationsWorkspace::follow);
    connect(m_variation, &CurrentVariation::resultChanged, this, &VariationsWorkspace::followResult);
    connect(&m_view->message(), &widgets::MessageStrip::actionTriggered, this, [this] {
        const VariationResults::State* resultState = m_variation->resultState();
        if (resultState != nullptr && resultState->isStopped)
            m_context.variations.learn(m_variation->name());
        else
            m_context.variations.retry(m_variation->name());
    });
    connect(&context.media, &SequenceMedia::changed, this,
            [this](const QString& name) { scene().update(name); });
    connect(&m_view->viewport(), &widgets::Viewport::picked, this,
            [this](const widgets::Pick& pick, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
                for (const DrawnVariation& drawn : m_variation->drawn()) {
                    if (button == Qt::LeftButton && scene().figureOf(nameOf(drawn)) == pick.figure)
                        emit m_variation->picked(drawn.inSet, modifiers.testFlag(Qt::ControlModifier));
                }
            });
    connect(m_view, &SceneView::sceneChanged, this,
            [this] { m_view->timeline().setFrameCount(static_cast<int>(scene().frameCount())); });
    retranslates(this, [this] { followResult(); });
}

ClipScene::Source VariationsWorkspace::source()
{
    return {.clip = [this](const QString& name, bool) { return clip(name); },
            .upAxis = [this] { return m_context.media.upAxis(); },
            .color =
                [this](const QString& name) {
                    for (const DrawnVariation& drawn : m_variation->drawn()) {
                        if (nameOf(drawn) == name)
                            return CurrentVariation::colorOf(drawn.inSet);
                    }
                    return widgets::Theme::color(widgets::ColorRole::Clay);
                }};
}

void VariationsWorkspace::makeActions()
{
    m_context.actions.addToggle(
        {"variations.original",
         [] { return tr("Variations"); },
         [] { return tr("Show the &take, too"); },
         [] { return tr("Shows what was captured, the takes that are varied, among the variations"); },
         "compare",
         {}},
        false, [this](bool shown) { m_variation->setOriginalShown(shown); });
}

void VariationsWorkspace::makePanels()
{
    m_panels.push_back({"movementDock", [] { return tr("Movement"); }, new MovementPanel(*m_variation)});
    auto* bodyParts = new BodyPartsPanel(*m_parts);
    m_panels.push_back({"bodyPartsDock", [] { return tr("Body parts"); }, bodyParts});
    m_panels.push_back({"learningDock", [] { return tr("Learning"); }, new LearningPanel(*m_variation)});
    auto* samples = new SamplesPanel(*m_variation);
    m_panels.push_back({"samplesDock", [] { return tr("Samples"); }, samples});
    connect(samples, &SamplesPanel::exportRequested, this,
            [this] { emit exportRequested(QStringLiteral("variations/") + m_variation->name()); });
    m_latent = new LatentPanel(*m_variation);
    Panel latent{"latentDock", [] { return tr("Latent space"); }, m_latent};
    latent.isLower = true;
    m_panels.push_back(std::move(latent));
    Panel warps{"warpDock", [] { return tr("Warps"); }, new WarpPanel(*m_variation)};
    warps.isLower = true;
    m_panels.push_back(std::move(warps));
    m_bodyPartsFront = new PanelFront(*bodyParts);
    m_samplesFront = new PanelFront(*samples);
    followPanels();
}

void VariationsWorkspace::followPanels()
{
    connect(m_bodyPartsFront, &PanelFront::changed, this, &VariationsWorkspace::setCutting);
    connect(m_samplesFront, &PanelFront::changed, this,
            [this](bool isInFront) { setCutting(m_bodyPartsFront->isInFront() && !isInFront); });
    connect(m_parts, &PartCurveTool::panelRequested, this, [this] { setCutting(true); });
    connect(&m_context.selection, &Selection::changed, this, [this] {
        const EntryRef& current = m_context.selection.current();
        if (m_isActive && current.section == Section::BodyParts && !current.name.isEmpty())
            showPanel(qobject_cast<QWidget*>(m_bodyPartsFront->parent()));
    });
    connect(m_parts, &PartCurveTool::visibilityRequested, this, &VariationsWorkspace::showParts);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget* /*before*/, QWidget* now) {
        for (const PanelFront* front : {m_bodyPartsFront.data(), m_samplesFront.data()}) {
            if (front == nullptr)
                continue; // panels lose the focus one after the other when the window goes
            const auto* panel = qobject_cast<QWidget*>(front->parent());
            if (front->isInFront() && now != nullptr && panel->isAncestorOf(now))
                setCutting(front == m_bodyPartsFront);
        }
    });
}

void VariationsWorkspace::setCutting(bool cutting)
{
    if (cutting == m_isCutting)
        return;
    m_isCutting = cutting;
    showParts();
    QMetaObject::invokeMethod(this, &VariationsWorkspace::followResult, Qt::QueuedConnection);
}

void VariationsWorkspace::showParts()
{
    m_parts->setActive(m_isCutting &&
                       m_context.actions.action(QStringLiteral("variations.parts.show"))->isChecked());
}

std::optional<NamedFrame> VariationsWorkspace::shownPose()
{
    const SamplesEntry* set = m_variation->samples();
    const QString take =
        set == nullptr ? m_context.selection.shownSequence() : QString::fromStdString(set->of);
    const MeshSequence* sequence = m_context.media.sequence(take);
    if (sequence == nullptr)
        return std::nullopt;
    const std::int64_t first =
        showsWholeTakes() ? 0 : m_variation->framesUsed().value_or(FrameRange{}).first.value;
    return NamedFrame{
        take.toStdString(),
        FrameIndex(std::clamp<std::int64_t>(player().frame().value + first, 0, sequence->frameCount() - 1))};
}

void VariationsWorkspace::setActive(bool active)
{
    m_isActive = active;
    if (active && m_context.selection.current().section == Section::BodyParts)
        showPanel(qobject_cast<QWidget*>(m_bodyPartsFront->parent()));
    follow();
}

bool VariationsWorkspace::showsWholeTakes() const
{
    return m_isCutting || m_variation->drawn().empty();
}

const MeshSequence* VariationsWorkspace::clip(const QString& name)
{
    const std::vector<DrawnVariation> all = m_variation->drawn();
    const auto found = std::ranges::find(all, name, [](const DrawnVariation& each) { return nameOf(each); });
    if (found != all.end())
        return m_context.variations.clip(m_variation->name(), found->number);
    const MeshSequence* take = m_context.media.sequence(name);
    if (take == nullptr || showsWholeTakes())
        return take;
    const auto used = framesLearned(*m_variation, name);
    if (!used)
        return take;
    MeshSequence& original = m_originals[name];
    original = take->cutTo(*used);
    return &original;
}

/// Takes are aligned and variations drawn only while somebody looks.
void VariationsWorkspace::follow()
{
    if (!m_isActive)
        return;
    m_context.variations.want(m_variation->name().isEmpty() ? QStringList()
                                                            : QStringList{m_variation->name()});
    followResult();
}

void VariationsWorkspace::followResult()
{
    QStringList names;
    const SamplesEntry* set = m_variation->samples();
    const QString take = set == nullptr ? QString() : QString::fromStdString(set->of);
    const std::vector<DrawnVariation> all =
        m_isCutting ? std::vector<DrawnVariation>() : m_variation->drawn();
    if (m_variation->isOriginalShown() && !all.empty())
        names += takesOfSet(*set);
    for (const DrawnVariation& drawn : all) {
        if (!drawn.isDiscarded && !m_variation->isHidden(drawn.inSet))
            names += nameOf(drawn);
    }
    if (names.isEmpty() && (set != nullptr || !m_context.selection.shownSequence().isEmpty()))
        names += set == nullptr ? m_context.selection.shownSequence() : take;
    if (m_isActive) {
        if (names == scene().shown()) {
            for (const QString& name : std::as_const(names))
                scene().update(name);
        } else {
            m_view->show(names);
        }
    }
    showState();
}

/// Says what is on its way, missing or went wrong, where it will be seen.
void VariationsWorkspace::showState()
{
    QString notice;
    if (m_context.document.project().sequences.empty())
        notice = tr("Import sequences first: variations are learned from them.");
    viewport().setNotice(notice);
    const VariationResults::State* resultState = m_variation->resultState();
    widgets::MessageStrip& message = m_view->message();
    if (resultState != nullptr && resultState->error) {
        const ErrorText text = describe(*resultState->error);
        message.show(widgets::MessageStrip::Kind::Error, text.placed(), text.remedy);
        message.setAction(tr("Try again"));
    } else if (resultState != nullptr && resultState->isStopped) {
        message.show(widgets::MessageStrip::Kind::Info,
                     tr("Learning was stopped: these variations are drawn from the best so far."),
                     tr("What is exported or added as sequences is learned to the end first, so that the "
                        "project always makes the same of it."));
        message.setAction(tr("Learn to the end"));
    } else {
        message.clear();
    }
}

} // namespace quadrille

#include "moc_variationsworkspace.cpp"

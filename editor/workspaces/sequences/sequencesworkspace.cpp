// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/sequences/sequencesworkspace.h"

#include "editor/application/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/sequences/contactproposal.h"
#include "editor/workspaces/sequences/posecomparison.h"
#include "editor/workspaces/sequences/sequencetimeline.h"
#include "widgets/controls/messagestrip.h"

#include <QVBoxLayout>

namespace quadrille {

namespace {

/// One sequence alone is shown untrimmed, several as the project uses them.
SequenceStage::Source sourceOf(const SequenceMedia& media)
{
    return {.clip =
                [&media](const QString& name, bool isComparing) {
                    return isComparing ? media.sequence(name) : media.untrimmed(name);
                },
            .upAxis = [&media] { return media.upAxis(); }};
}

} // namespace

SequencesWorkspace::SequencesWorkspace(EditorContext& context, QWidget* parent)
    : Workspace(parent)
    , m_context(context)
    , m_view(new StageView(context, sourceOf(context.media), QString()))
    , m_sequenceTimeline(new SequenceTimeline(m_view->timeline(), context.document, context.media, this))
    , m_contacts(new ContactProposal(context, this))
    , m_comparison(new PoseComparison(context, m_view->viewport(), m_view->stage(), this))
{
    setObjectName(QStringLiteral("sequencesWorkspace"));
    makeEditActions();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view);
    widgets::MessageStrip& message = m_view->message();
    connect(m_contacts, &ContactProposal::foundNothing, this, [&message](const QString& name) {
        message.show(widgets::MessageStrip::Kind::Info, tr("No foot contacts were found in “%1”.").arg(name),
                     tr("Mark them by hand: draw in the track of a foot in the timeline."));
        message.setAction({});
    });
    connect(&message, &widgets::MessageStrip::actionTriggered, this,
            [this] { m_context.media.retry(m_context.selection.shownSequence()); });
    connect(m_comparison, &PoseComparison::changed, this, &SequencesWorkspace::showState);
    connect(&context.media, &SequenceMedia::changed, m_view,
            [this](const QString& name) { stage().update(name); });
    connect(&context.selection, &Selection::changed, this, &SequencesWorkspace::followSelection);
    connect(m_view, &StageView::stageChanged, this, &SequencesWorkspace::followStage);
    connect(m_sequenceTimeline, &SequenceTimeline::rangeChanged, m_view, &StageView::updateRange);
    retranslates(this, [this] { showState(); });
}

void SequencesWorkspace::makeEditActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto edit = [] { return tr("Edit"); };
    actions.add({"edit.trimStart", edit, [] { return tr("Trim &start to here"); }, {}, "trim", {Qt::Key_I}},
                [this] { m_sequenceTimeline->trimStartHere(); });
    actions.add({"edit.trimEnd", edit, [] { return tr("Trim &end to here"); }, {}, "trim", {Qt::Key_O}},
                [this] { m_sequenceTimeline->trimEndHere(); });
    actions.add({"edit.untrim", edit, [] { return tr("Use &all frames"); }, {}, "trim", {}},
                [this] { m_sequenceTimeline->removeTrim(); });
    actions.add({"edit.label", edit, [] { return tr("Add a &label"); }, {}, "label", {Qt::Key_M}},
                [this] { m_sequenceTimeline->addLabel(); });
}

/// What is not seen is not trimmed, and its keys mean something else elsewhere.
void SequencesWorkspace::setActive(bool active)
{
    for (const char* id : {"edit.trimStart", "edit.trimEnd", "edit.untrim", "edit.label"})
        m_context.actions.action(QLatin1String(id))->setEnabled(active);
}

std::optional<NamedFrame> SequencesWorkspace::shownPose()
{
    const QString& name = m_context.selection.shownSequence();
    const MeshSequence* sequence = m_context.media.sequence(name);
    if (sequence == nullptr)
        return std::nullopt;
    // One sequence alone is shown with all frames of its source.
    const std::int64_t first = stage().isComparing() ? 0 : m_context.media.usedFrames(name).first.value;
    const std::int64_t frame = player().frame().value - first;
    return NamedFrame{name.toStdString(),
                      FrameIndex(std::clamp<std::int64_t>(frame, 0, sequence->frameCount() - 1))};
}

void SequencesWorkspace::followSelection()
{
    const QStringList& names = m_context.selection.sequences();
    m_view->message().clear();
    m_view->show(names.size() > 1 ? names : QStringList{m_context.selection.shownSequence()});
    m_view->setCurrent(m_context.selection.shownSequence());
}

void SequencesWorkspace::followStage()
{
    const std::int64_t frames = stage().frameCount();
    m_sequenceTimeline->show(m_context.selection.shownSequence(), stage().isComparing() ? frames : 0);
    showState();
}

/// Says what is on its way or went wrong, where it will be seen.
void SequencesWorkspace::showState()
{
    const QString& name = m_context.selection.shownSequence();
    const auto* medium = m_context.media.medium(name);
    widgets::MessageStrip& message = m_view->message();
    QString notice;
    if (medium == nullptr)
        notice = tr("No sequences yet. Drop files here, or import them from the File menu.");
    else if (medium->state == SequenceMedia::State::Loading && stage().isEmpty())
        notice = tr("Opening “%1”…").arg(name);
    else if (medium->state == SequenceMedia::State::Failed && stage().isEmpty())
        notice = tr("“%1” cannot be shown.").arg(name);
    viewport().setNotice(notice);
    if (medium != nullptr && medium->error) {
        const ErrorText text = describe(*medium->error);
        const QString sentence =
            text.where.isEmpty() ? text.sentence : tr("%1 (%2)").arg(text.sentence, text.where);
        message.show(widgets::MessageStrip::Kind::Error, sentence, text.remedy);
        message.setAction(tr("Try Again"));
    } else if (const QString problem = m_comparison->problem(); !problem.isEmpty()) {
        message.show(widgets::MessageStrip::Kind::Warning, problem, m_comparison->remedy());
        message.setAction({});
    } else if (message.kind() != widgets::MessageStrip::Kind::Info) {
        message.clear();
    }
}

} // namespace quadrille

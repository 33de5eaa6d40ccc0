// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/sequences/sequencesworkspace.h"

#include "editor/commands/markedits.h"
#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/sequences/contactproposal.h"
#include "editor/workspaces/sequences/labeltakes.h"
#include "editor/workspaces/sequences/posecomparison.h"
#include "editor/workspaces/sequences/sequencetimeline.h"
#include "editor/workspaces/view/framenotes.h"
#include "editor/workspaces/view/notespanel.h"
#include "editor/workspaces/view/timelineactions.h"
#include "widgets/controls/messagestrip.h"

#include <QVBoxLayout>

namespace quadrille {

namespace {

/// One sequence alone is shown untrimmed, several as the project uses them.
ClipScene::Source sourceOf(const SequenceMedia& media)
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
    , m_view(new SceneView(context, sourceOf(context.media), QString()))
    , m_sequenceTimeline(new SequenceTimeline(m_view->timeline(), context.document, context.media, this))
    , m_contacts(new ContactProposal(context, this))
    , m_comparison(new PoseComparison(context, m_view->viewport(), m_view->scene(), this))
{
    setObjectName(QStringLiteral("sequencesWorkspace"));
    makeNotes();
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
            [this](const QString& name) { scene().update(name); });
    connect(&context.selection, &Selection::changed, this, &SequencesWorkspace::followSelection);
    connect(m_view, &SceneView::sceneChanged, this, &SequencesWorkspace::followScene);
    connect(m_sequenceTimeline, &SequenceTimeline::rangeChanged, m_view, &SceneView::updateRange);
    connect(m_sequenceTimeline, &SequenceTimeline::menuOpened, this,
            [this](QMenu* menu, const QString& track, int frame) {
                addTimelineMenu(*menu, *m_view, m_context, track, frame);
            });
    retranslates(this, [this] { showState(); });
}

void SequencesWorkspace::makeNotes()
{
    const auto shown = [this] { return m_sequenceTimeline->sequence(); };
    m_notes = new FrameNotes(
        *m_view,
        {.notes = [this, shown]() -> std::optional<std::vector<FrameNote>> {
             if (!m_sequenceTimeline->isEditing())
                 return std::nullopt;
             return notesOf(m_context.document.sequence(shown())->unknown);
         },
         .keep =
             [this, shown](std::vector<FrameNote> notes, EditPhase phase) {
                 setSequenceNotes(m_context.document, shown(), std::move(notes), phase);
             },
         .firstFrame = [this,
                        shown] { return static_cast<int>(m_context.media.usedFrames(shown()).first.value); }},
        this);
    m_sequenceTimeline->setNotes(*m_notes);
    m_view->setNotes(m_notes);
    m_notesPanel = new NotesPanel(*m_notes);
    connect(m_sequenceTimeline, &SequenceTimeline::rangeChanged, m_notesPanel,
            [this] { m_notesPanel->refresh(m_context.document.project().settings.fps); });
}

std::vector<Workspace::Panel> SequencesWorkspace::panels()
{
    return {{"sequenceNotesDock", [] { return tr("Notes"); }, m_notesPanel, Qt::BottomDockWidgetArea, false}};
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
    actions.add(
        {"edit.labelTakes",
         edit,
         [] { return tr("Label the ta&kes…"); },
         [] { return tr("Give each of the selected takes a label over all of its frames"); },
         "label",
         {QKeySequence(Qt::CTRL | Qt::Key_M)}},
        [this] {
            LabelTakes(m_context.document, m_context.media, m_context.selection.sequences(), window()).exec();
        });
}

/// What is not seen is not trimmed, and its keys mean something else elsewhere.
void SequencesWorkspace::setActive(bool active)
{
    for (const char* id : {"edit.trimStart", "edit.trimEnd", "edit.untrim", "edit.label"})
        m_context.actions.action(QLatin1String(id))->setEnabled(active);
    // The properties are those of what is seen, not of what another workspace was left with.
    const Section section = m_context.selection.current().section;
    const QString& shown = m_context.selection.shownSequence();
    if (active && !shown.isEmpty() && (section == Section::Animations || section == Section::Variations))
        m_context.selection.selectSequences({shown});
}

std::optional<NamedFrame> SequencesWorkspace::shownPose()
{
    const QString& name = m_context.selection.shownSequence();
    const MeshSequence* sequence = m_context.media.sequence(name);
    if (sequence == nullptr)
        return std::nullopt;
    // One sequence alone is shown with all frames of its source.
    const std::int64_t first = scene().isComparing() ? 0 : m_context.media.usedFrames(name).first.value;
    const std::int64_t frame = player().frame().value - first;
    return NamedFrame{name.toStdString(),
                      FrameIndex(std::clamp<std::int64_t>(frame, 0, sequence->frameCount() - 1))};
}

void SequencesWorkspace::followSelection()
{
    const QStringList& names = m_context.selection.sequences();
    m_context.actions.action(QStringLiteral("edit.labelTakes"))->setEnabled(!names.isEmpty());
    m_view->message().clear();
    m_view->show(names.size() > 1 ? names : QStringList{m_context.selection.shownSequence()});
    m_view->setCurrent(m_context.selection.shownSequence());
}

void SequencesWorkspace::followScene()
{
    const std::int64_t frames = scene().frameCount();
    m_sequenceTimeline->show(m_context.selection.shownSequence(), scene().isComparing() ? frames : 0);
    showState();
}

/// Says what is on its way or went wrong, where it will be seen.
void SequencesWorkspace::showState()
{
    const QString& name = m_context.selection.shownSequence();
    const auto* resultState = m_context.media.resultState(name);
    widgets::MessageStrip& message = m_view->message();
    QString notice;
    if (resultState == nullptr)
        notice = tr("No sequences yet. Drop files here, or import them from the File menu.");
    else if (resultState->phase == ResultPhase::Computing && scene().isEmpty())
        notice = tr("Opening “%1”…").arg(name);
    else if (resultState->phase == ResultPhase::Failed && scene().isEmpty())
        notice = tr("“%1” cannot be shown.").arg(name);
    viewport().setNotice(notice);
    if (resultState != nullptr && resultState->error) {
        const ErrorText text = describe(*resultState->error);
        message.show(widgets::MessageStrip::Kind::Error, text.placed(), text.remedy);
        message.setAction(tr("Try again"));
    } else if (const QString problem = m_comparison->problem(); !problem.isEmpty()) {
        message.show(widgets::MessageStrip::Kind::Warning, problem, m_comparison->remedy());
        message.setAction({});
    } else if (message.kind() != widgets::MessageStrip::Kind::Info) {
        message.clear();
    }
}

} // namespace quadrille

#include "moc_sequencesworkspace.cpp"

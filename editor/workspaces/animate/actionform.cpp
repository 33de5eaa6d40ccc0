// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/actionform.h"

#include "editor/documents/labelcolors.h"
#include "editor/documents/sequencemedia.h"
#include "editor/fields/rangefield.h"
#include "editor/workspaces/animate/animationtracks.h"
#include "model/synthesis/walks/constraints.h"
#include "widgets/storyboard/rangestrip.h"
#include "widgets/theme/theme.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr double usualSeconds = 3;
constexpr double percent = 0.01;

bool isOfSequence(const ActionEntry& action)
{
    return !action.frames.sequence.empty();
}

bool goesOn(const ActionEntry& action)
{
    return action.duration.has_value();
}

} // namespace

ActionForm::ActionForm(ProjectDocument& document, SequenceMedia& media, QWidget* parent)
    : LabelForm(parent)
    , m_document(document)
    , m_media(media)
    , m_fields(*this,
               [this](const QString& text, const char* property, const auto& change) {
                   if (!m_action)
                       return;
                   change(*m_action);
                   emit edited(*m_action, text, QLatin1String(property), EditPhase::Final);
               })
    , m_title(new QLabel)
    , m_range(new RangeField("action"))
    , m_strip(new widgets::RangeStrip)
{
    setObjectName(QStringLiteral("actionForm"));
    QFont heading = font();
    heading.setWeight(QFont::DemiBold);
    m_title->setFont(heading);
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    addWide("actionTitle", m_title);
    addFrames();
    addPlaying();
    connect(&media, &SequenceMedia::changed, this, [this] { show(m_action); });
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, [this] { show(m_action); });
    retranslate();
}

void ActionForm::addFrames()
{
    connect(m_range, &RangeField::edited, this, [this] { setRange(m_range->range(), EditPhase::Final); });
    connect(m_strip, &widgets::RangeStrip::rangeEdited, this, [this](int first, int last, bool committed) {
        const bool isAll = first == 0 && last == m_strip->frameCount() - 1;
        setRange(isAll ? std::nullopt : std::optional(FrameRange{FrameIndex(first), FrameIndex(last)}),
                 committed ? EditPhase::Final : EditPhase::Dragging);
    });
    m_fields.addOther({"actionFrames", [] { return tr("Frames"); },
                       [] { return tr("First and last frame of the take that are played"); }, isOfSequence},
                      m_range, [this](const ActionEntry& action) { showFrames(action); });
    m_fields.addOther(
        {"actionRange",
         {},
         [] { return tr("Drag the ends to choose the frames; ← and → move the active end by a frame"); },
         isOfSequence},
        m_strip, [](const ActionEntry&) {});
}

void ActionForm::addPlaying()
{
    m_repeat = m_fields.addNumber(
        {"actionRepeat",
         [] { return tr("Times"); },
         [] { return tr("How often it is performed"); },
         {},
         [] { return tr("Change how often an action is performed"); }},
        &ActionEntry::repeat,
        {.path = "action.repeat", .step = 1, .decimals = 0, .unit = [] { return tr(" ×"); }});
    const auto goesOnTip = [] { return tr("It goes on for a time, with any of its frames in any order"); };
    const auto history = [] { return tr("Change the duration of an action"); };
    m_fields.addSwitch({"actionHasDuration", [] { return tr("Goes on for"); }, goesOnTip, {}, history},
                       Lens<ActionEntry, bool>{goesOn, [](ActionEntry& action, bool isOn) {
                                                   action.duration =
                                                       isOn ? std::optional(usualSeconds) : std::nullopt;
                                               }});
    m_fields.addNumber({"actionDuration", [] { return tr("Duration"); }, goesOnTip, goesOn, history},
                       Lens<ActionEntry, double>{
                           [](const ActionEntry& action) { return action.duration.value_or(usualSeconds); },
                           [](ActionEntry& action, double seconds) { action.duration = seconds; }},
                       {.path = "action.duration", .step = 0.5, .unit = [] { return tr(" s"); }});
    m_share = m_fields.addNumber(
        {"actionShare",
         [] { return tr("At least"); },
         [] {
             return tr("How much of the frames must be played; the rest may be left out at both ends to "
                       "join it better");
         },
         {},
         [] { return tr("Change how much of an action is played"); }},
        Lens<ActionEntry, double>{
            [](const ActionEntry& action) { return action.leastShare.value_or(Action().leastShare); },
            [](ActionEntry& action, double share) {
                action.leastShare = share == Action().leastShare ? std::nullopt : std::optional(share);
            }},
        {.path = "action.least_share", .scale = percent, .step = 1, .decimals = 0, .unit = [] {
             return tr(" %");
         }});
}

void ActionForm::setRange(const std::optional<FrameRange>& range, EditPhase phase)
{
    if (!m_action)
        return;
    m_action->frames.range = range;
    emit edited(*m_action, tr("Change the frames of an action"), QStringLiteral("actionRange"), phase);
}

void ActionForm::show(const std::optional<ActionEntry>& action)
{
    m_action = action;
    setEnabled(action.has_value());
    const ActionEntry shown = action.value_or(ActionEntry());
    m_title->setText(!action ? tr("No card selected")
                     : isOfSequence(shown)
                         ? QString::fromStdString(shown.frames.sequence)
                         : tr("Label “%1”").arg(QString::fromStdString(shown.frames.label)));
    m_title->setToolTip(m_title->text());
    m_fields.show(shown);
    m_repeat->setEnabled(!goesOn(shown));
    m_share->setEnabled(!goesOn(shown));
}

void ActionForm::showFrames(const ActionEntry& action)
{
    if (!isOfSequence(action))
        return;
    const QString name = QString::fromStdString(action.frames.sequence);
    const MeshSequence* sequence = m_media.sequence(name);
    const std::int64_t frames = sequence == nullptr ? 0 : sequence->frameCount();
    std::optional<FrameRange> range = action.frames.range;
    if (frames > 0 && range) // what is beyond the take is not played
        range = FrameRange{std::clamp(range->first, FrameIndex(0), FrameIndex(frames - 1)),
                           std::clamp(range->last, FrameIndex(0), FrameIndex(frames - 1))};
    m_range->setRange(range, frames);
    m_strip->setEnabled(frames > 0);
    if (frames == 0)
        return;
    const FrameRange played = range.value_or(FrameRange::all(frames));
    m_strip->setFrameCount(static_cast<int>(frames));
    m_strip->setRange(static_cast<int>(played.first.value), static_cast<int>(played.last.value));
    std::vector<widgets::TimelineSpan> spans;
    if (const SequenceEntry* entry = m_document.sequence(name))
        for (const LabelSpan& span : entry->labels)
            spans.push_back({.first = static_cast<int>(span.frames.first.value),
                             .last = static_cast<int>(span.frames.last.value),
                             .text = QString::fromStdString(span.label),
                             .color = LabelColors::of(m_document).color(span.label)});
    m_strip->setSpans(std::move(spans));
}

void ActionForm::edit()
{
    QWidget* field = m_range->isVisibleTo(this) ? static_cast<QWidget*>(m_range) : m_repeat;
    field->setFocus(Qt::OtherFocusReason);
}

void ActionForm::retranslate()
{
    m_fields.retranslate();
    show(m_action);
}

} // namespace quadrille

#include "moc_actionform.cpp"

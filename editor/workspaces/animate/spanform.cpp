// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/context/editorcontext.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathfields.h"
#include "editor/workspaces/animate/pathforms.h"
#include "editor/workspaces/animate/pathtool.h"
#include "model/project/results/openanimation.h"
#include "widgets/theme/icons.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>

namespace quadrille {

SpanForm::SpanForm(PathTool& tool)
    : m_tool(tool)
    , m_frames(new QComboBox)
    , m_range(new QWidget)
    , m_first(new QSpinBox)
    , m_last(new QSpinBox)
    , m_from(numberField(0, 2, 0.1))
    , m_to(numberField(0.01, 2, 0.1))
    , m_duration(numberField(0, 2, 0.1))
    , m_speed(numberField(0, 2, 0.1))
{
    m_frames->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_frames->setMinimumContentsLength(8);
    m_first->setObjectName(QStringLiteral("spanFirst"));
    m_last->setObjectName(QStringLiteral("spanLast"));
    auto* range = new QHBoxLayout(m_range);
    range->setContentsMargins(0, 0, 0, 0);
    range->setSpacing(4);
    for (QSpinBox* field : {m_first, m_last}) {
        field->setKeyboardTracking(false);
        range->addWidget(field, 1);
        connect(field, &QSpinBox::valueChanged, this, &SpanForm::chooseRange);
    }
    m_range->setFocusProxy(m_first);
    addField(
        "spanFrames", [] { return tr("Show"); }, m_frames,
        [] { return tr("The only frames that may be played there: those with a label, or of a sequence"); });
    addField(
        "spanRange", [] { return tr("Frames"); }, m_range,
        [] { return tr("First and last frame of the sequence that may be played"); });
    addField(
        "spanFrom", [] { return tr("From"); }, m_from,
        [] { return tr("Where the span begins, along the path"); });
    addField(
        "spanTo", [] { return tr("To"); }, m_to, [] { return tr("Where the span ends, along the path"); });
    addField(
        "spanDuration", [] { return tr("Lasts"); }, m_duration,
        [] { return tr("How long the span is to take; 0: as long as it takes"); });
    addField(
        "spanSpeed", [] { return tr("Speed"); }, m_speed,
        [] { return tr("How fast the body is to go there; 0: as fast as it goes"); });
    m_obtained = addFact("spanObtained", [] { return tr("Result"); });
    connect(m_frames, &QComboBox::activated, this, &SpanForm::chooseFrames);
    const auto ends = [this] {
        edit(tr("Move the end of a span"), "ends", [this](PathSpanEntry& span) {
            // The shown length of the path, or more, stands for its end.
            const double shortest = 0.01 / settingsOf(m_tool).axes.metresPerUnit;
            const double end = m_tool.length();
            span.from = std::clamp(valueOf(m_from, span.from), 0.0, std::max(0.0, end - shortest));
            span.to = std::max(std::min(valueOf(m_to, span.to), end), std::min(span.from + shortest, end));
        });
        show();
    };
    connect(m_from, &QDoubleSpinBox::valueChanged, this, ends);
    connect(m_to, &QDoubleSpinBox::valueChanged, this, ends);
    connect(m_duration, &QDoubleSpinBox::valueChanged, this, [this](double seconds) {
        edit(tr("Change how long a span takes"), "duration", [seconds](PathSpanEntry& span) {
            span.duration = seconds > 0 ? std::optional(seconds) : std::nullopt;
        });
    });
    connect(m_speed, &QDoubleSpinBox::valueChanged, this, [this](double speed) {
        edit(tr("Change the speed of a span"), "duration", [this, speed](PathSpanEntry& span) {
            const double metres = (span.to - span.from) * settingsOf(m_tool).axes.metresPerUnit;
            span.duration = speed > 0 ? std::optional(metres / speed) : std::nullopt;
        });
    });
}

const PathSpanEntry* SpanForm::span() const
{
    const PathEntry* path = m_tool.path();
    const bool isThere = path != nullptr && m_span >= 0 && m_span < static_cast<int>(path->spans.size());
    return isThere ? &path->spans[static_cast<std::size_t>(m_span)] : nullptr;
}

void SpanForm::edit(const QString& text, const char* property,
                    const std::function<void(PathSpanEntry&)>& edit)
{
    if (span() == nullptr)
        return;
    m_tool.edit(text, QStringLiteral("path span %1 %2").arg(m_span).arg(QLatin1String(property)),
                [&](PathEntry& path) { edit(path.spans[static_cast<std::size_t>(m_span)]); });
}

void SpanForm::showSpan(int span)
{
    m_span = span;
    show();
}

/// Any frames, labels, sequences; the data of an item tells which by "label" or "sequence".
void SpanForm::fillFrames()
{
    const Project& project = m_tool.animation().context().document.project();
    QStringList labels;
    QStringList sequences;
    for (const SequenceEntry& sequence : project.sequences) {
        sequences += QString::fromStdString(sequence.name);
        for (const LabelSpan& span : sequence.labels)
            labels += QString::fromStdString(span.label);
    }
    labels.removeDuplicates();
    labels.sort(Qt::CaseInsensitive);
    m_frames->clear();
    m_frames->addItem(tr("Any frames"), QStringList());
    for (const QString& label : labels)
        m_frames->addItem(widgets::icons::icon(QStringLiteral("label")), label,
                          QStringList{QStringLiteral("label"), label});
    for (const QString& sequence : sequences)
        m_frames->addItem(widgets::icons::icon(QStringLiteral("sequence")), sequence,
                          QStringList{QStringLiteral("sequence"), sequence});
}

void SpanForm::chooseFrames(int index)
{
    const QStringList chosen = m_frames->itemData(index).toStringList();
    edit(tr("Choose the frames of a span"), "frames", [&](PathSpanEntry& span) {
        span.frames.reset();
        if (chosen.isEmpty())
            return;
        span.frames.emplace();
        (chosen.front() == QLatin1String("label") ? span.frames->label : span.frames->sequence) =
            chosen.back().toStdString();
    });
}

void SpanForm::chooseRange()
{
    edit(tr("Choose the frames of a span"), "frames", [this](PathSpanEntry& span) {
        if (!span.frames || span.frames->sequence.empty())
            return;
        const bool isAll = m_first->value() == m_first->minimum() && m_last->value() == m_last->maximum();
        const std::int64_t first = m_first->value();
        span.frames->range =
            isAll ? std::nullopt
                  : std::optional(FrameRange{FrameIndex(first),
                                             FrameIndex(std::max<std::int64_t>(first, m_last->value()))});
    });
}

/// What the walk that is shown makes of the span.
QString SpanForm::obtainedText() const
{
    const auto result = m_tool.animation().result();
    const auto index = static_cast<std::size_t>(m_span);
    if (!result || index >= result->walk.solution.spans.size() ||
        result->walk.solution.spans[index].count() == 0)
        return QStringLiteral("–");
    const auto frames = static_cast<double>(result->walk.solution.spans[index].count());
    const double seconds = frames / settingsOf(m_tool).fps;
    const PathSpanEntry& own = *span();
    const double metres = (own.to - own.from) * settingsOf(m_tool).axes.metresPerUnit;
    return tr("%1 s, %2 m/s")
        .arg(QLocale().toString(seconds, 'f', 2), QLocale().toString(metres / seconds, 'f', 2));
}

void SpanForm::show(const QString& /*name*/)
{
    const PathSpanEntry* shown = span();
    setVisible(shown != nullptr);
    if (shown == nullptr)
        return;
    setUnit(m_tool, {m_from, m_to});
    m_duration->setSuffix(tr(" s"));
    m_speed->setSuffix(tr(" m/s"));
    m_duration->setSpecialValueText(tr("any"));
    m_speed->setSpecialValueText(tr("any"));
    setValue(m_from, shown->from);
    setValue(m_to, shown->to);
    setValue(m_duration, shown->duration.value_or(0));
    const double metres = (shown->to - shown->from) * settingsOf(m_tool).axes.metresPerUnit;
    setValue(m_speed, shown->duration ? metres / *shown->duration : 0);
    m_obtained->setText(obtainedText());
    fillFrames();
    QStringList wanted;
    if (shown->frames && !shown->frames->label.empty())
        wanted = {QStringLiteral("label"), QString::fromStdString(shown->frames->label)};
    else if (shown->frames)
        wanted = {QStringLiteral("sequence"), QString::fromStdString(shown->frames->sequence)};
    int index = m_frames->findData(wanted);
    if (index < 0) { // a label that no sequence has any more
        m_frames->addItem(tr("%1 (missing)").arg(wanted.back()), wanted);
        index = m_frames->count() - 1;
    }
    m_frames->setCurrentIndex(index);
    const bool isSequence = shown->frames && !shown->frames->sequence.empty();
    setFieldVisible(m_range, isSequence);
    if (!isSequence)
        return;
    const EditorContext& context = m_tool.animation().context();
    const MeshSequence* sequence = context.media.sequence(QString::fromStdString(shown->frames->sequence));
    const int last = sequence == nullptr ? 999999 : static_cast<int>(sequence->frameCount()) - 1;
    for (QSpinBox* field : {m_first, m_last}) {
        const QSignalBlocker quiet(field);
        field->setRange(0, std::max(0, last));
        field->setValue(field == m_first ? 0 : last);
        if (shown->frames->range)
            field->setValue(static_cast<int>(field == m_first ? shown->frames->range->first.value
                                                              : shown->frames->range->last.value));
    }
}

} // namespace quadrille

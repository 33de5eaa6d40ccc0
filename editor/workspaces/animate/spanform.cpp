// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/context/editorcontext.h"
#include "editor/fields/rangefield.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathfields.h"
#include "editor/workspaces/animate/pathforms.h"
#include "editor/workspaces/animate/pathtool.h"
#include "model/project/results/openanimation.h"
#include "widgets/theme/icons.h"

#include <QLocale>
#include <algorithm>
#include <set>

namespace quadrille {

namespace {

double metresOf(const PathTool& tool, const PathSpanEntry& span)
{
    return (span.to - span.from) * settingsOf(tool).axes.metresPerUnit;
}

bool isOfTake(const PathSpanEntry& span)
{
    return span.frames && !span.frames->sequence.empty();
}

using Frames = std::optional<FrameChoice>;

/// Any frames, labels, sequences; and what is chosen, be it a label that no sequence has any more.
std::vector<FieldItem<Frames>> framesFor(const Project& project, const Frames& chosen)
{
    std::vector<FieldItem<Frames>> items{{SpanForm::tr("Any frames"), {}}};
    std::set<QString, std::less<>> labels;
    for (const SequenceEntry& sequence : project.sequences)
        for (const LabelSpan& span : sequence.labels)
            labels.insert(QString::fromStdString(span.label));
    for (const QString& label : labels)
        items.push_back({label, FrameChoice{.label = label.toStdString()},
                         widgets::icons::icon(QStringLiteral("label"))});
    for (const SequenceEntry& sequence : project.sequences)
        items.push_back({QString::fromStdString(sequence.name), FrameChoice{.sequence = sequence.name},
                         widgets::icons::icon(QStringLiteral("sequence"))});
    if (std::ranges::find(items, chosen, &FieldItem<Frames>::value) == items.end())
        items.push_back(
            {SpanForm::tr("%1 (missing)")
                 .arg(QString::fromStdString(chosen->label.empty() ? chosen->sequence : chosen->label)),
             chosen});
    return items;
}

Frames withoutRange(Frames frames)
{
    if (frames)
        frames->range.reset();
    return frames;
}

} // namespace

SpanForm::SpanForm(PathTool& tool)
    : m_tool(tool), m_fields(*this, [this](const QString& text, const char* property, const auto& change) {
        edit(text, property, change);
    })
{
    addFrames();
    addEnds();
    addTimes();
    m_obtained = addFact("spanObtained", [] { return tr("Result"); });
    m_fields.retranslate();
}

void SpanForm::addFrames()
{
    const auto history = [] { return tr("Choose the frames of a span"); };
    m_fields.addItems(
        {"spanFrames",
         [] { return tr("Show"); },
         [] { return tr("The only frames that may be played there: those with a label, or of a sequence"); },
         {},
         history},
        Lens<PathSpanEntry, Frames>{
            [](const PathSpanEntry& span) { return withoutRange(span.frames); },
            [](PathSpanEntry& span, Frames frames) { span.frames = std::move(frames); }},
        [this](const PathSpanEntry& span) {
            return framesFor(m_tool.animation().context().document.project(), withoutRange(span.frames));
        });
    auto* range = new RangeField("span");
    connect(range, &RangeField::edited, this, [this, range, history] {
        edit(history(), "spanRange", [range](PathSpanEntry& span) { span.frames->range = range->range(); });
    });
    m_fields.addOther(
        {"spanRange", [] { return tr("Frames"); },
         [] { return tr("First and last frame of the sequence that may be played"); }, isOfTake},
        range, [this, range](const PathSpanEntry& span) {
            if (!isOfTake(span))
                return;
            const MeshSequence* sequence =
                m_tool.animation().context().media.sequence(QString::fromStdString(span.frames->sequence));
            range->setRange(span.frames->range, sequence == nullptr ? 0 : sequence->frameCount());
        });
}

void SpanForm::addEnds()
{
    // The shown length of the path, or more, stands for its end; each end moves the other where it has to.
    const auto set = [this](PathSpanEntry& span, double from, double to) {
        const double shortest = 0.01 / settingsOf(m_tool).axes.metresPerUnit;
        const double end = m_tool.length();
        span.from = std::clamp(from, 0.0, std::max(0.0, end - shortest));
        span.to = std::max(std::min(to, end), std::min(span.from + shortest, end));
    };
    const auto history = [] { return tr("Move the end of a span"); };
    auto from = lensOf<PathSpanEntry>(&PathSpanEntry::from);
    from.set = [set](PathSpanEntry& span, double length) { set(span, length, span.to); };
    auto to = lensOf<PathSpanEntry>(&PathSpanEntry::to);
    to.set = [set](PathSpanEntry& span, double length) { set(span, span.from, length); };
    m_fields.addNumber({"spanFrom",
                        [] { return tr("From"); },
                        [] { return tr("Where the span begins, along the path"); },
                        {},
                        history},
                       from, lengthLook(m_tool, "path_span.from", 0, 0.1));
    m_fields.addNumber({"spanTo",
                        [] { return tr("To"); },
                        [] { return tr("Where the span ends, along the path"); },
                        {},
                        history},
                       to, lengthLook(m_tool, "path_span.to", 0.01, 0.1));
}

void SpanForm::addTimes()
{
    m_fields.addNumber({"spanDuration",
                        [] { return tr("Lasts"); },
                        [] { return tr("How long the span is to take; 0: as long as it takes"); },
                        {},
                        [] { return tr("Change how long a span takes"); }},
                       &PathSpanEntry::duration,
                       {.path = "path_span.duration",
                        .unit = [] { return tr(" s"); },
                        .automatic = [] { return tr("any"); }});
    using Speed = std::optional<double>;
    m_fields.addNumber({"spanSpeed",
                        [] { return tr("Speed"); },
                        [] { return tr("How fast the body is to go there; 0: as fast as it goes"); },
                        {},
                        [] { return tr("Change the speed of a span"); }},
                       Lens<PathSpanEntry, Speed>{
                           [this](const PathSpanEntry& span) {
                               return span.duration ? Speed(metresOf(m_tool, span) / *span.duration)
                                                    : Speed();
                           },
                           [this](PathSpanEntry& span, Speed speed) {
                               span.duration = speed ? Speed(metresOf(m_tool, span) / *speed) : Speed();
                           }},
                       {.path = nullptr,
                        .unit = [] { return tr(" m/s"); },
                        .automatic = [] { return tr("any"); },
                        .lowest = 0.01});
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
    // A field may ask for more than there is; then nothing changes, and it shows what is again.
    refresh();
}

void SpanForm::showSpan(int span)
{
    m_span = span;
    refresh();
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
    return tr("%1 s, %2 m/s")
        .arg(QLocale().toString(seconds, 'f', 2),
             QLocale().toString(metresOf(m_tool, *span()) / seconds, 'f', 2));
}

void SpanForm::refresh()
{
    const PathSpanEntry* shown = span();
    setVisible(shown != nullptr);
    if (shown == nullptr)
        return;
    m_obtained->setText(obtainedText());
    m_fields.show(*shown);
}

void SpanForm::retranslate()
{
    m_fields.retranslate();
    refresh();
}

} // namespace quadrille

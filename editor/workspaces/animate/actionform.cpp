// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/actionform.h"

#include "editor/documents/labelcolors.h"
#include "editor/documents/sequencemedia.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/animate/animationtracks.h"
#include "model/synthesis/walks/constraints.h"
#include "widgets/storyboard/rangestrip.h"
#include "widgets/theme/theme.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr double usualSeconds = 3;

int usualShare()
{
    return static_cast<int>(std::lround(Action().leastShare * 100));
}

template <typename Field>
Field* namedNumberField(const char* name)
{
    auto* field = new Field;
    field->setObjectName(QLatin1String(name));
    field->setAlignment(Qt::AlignRight);
    field->setKeyboardTracking(false);
    field->setFont(widgets::Theme::tabularFont(field->font()));
    return field;
}

} // namespace

ActionForm::ActionForm(ProjectDocument& document, SequenceMedia& media, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_media(media)
    , m_form(new QFormLayout(this))
    , m_title(new QLabel)
    , m_framesLabel(new QLabel)
    , m_frames(new QWidget)
    , m_first(namedNumberField<QSpinBox>("actionFirst"))
    , m_last(namedNumberField<QSpinBox>("actionLast"))
    , m_strip(new widgets::RangeStrip)
    , m_repeatLabel(new QLabel)
    , m_repeat(namedNumberField<QSpinBox>("actionRepeat"))
    , m_hasDuration(new QCheckBox)
    , m_duration(namedNumberField<QDoubleSpinBox>("actionDuration"))
    , m_shareLabel(new QLabel)
    , m_share(namedNumberField<QSpinBox>("actionShare"))
{
    setObjectName(QStringLiteral("actionForm"));
    constexpr int margin = 8;
    constexpr int most = 1000;
    m_form->setContentsMargins(margin, margin, margin, margin);
    m_form->setHorizontalSpacing(margin);
    m_form->setVerticalSpacing(margin / 2);
    QFont heading = font();
    heading.setWeight(QFont::DemiBold);
    m_title->setObjectName(QStringLiteral("actionTitle"));
    m_title->setFont(heading);
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_strip->setObjectName(QStringLiteral("actionRange"));
    m_hasDuration->setObjectName(QStringLiteral("actionHasDuration"));
    m_repeat->setRange(1, most);
    m_duration->setRange(0.1, 3600);
    m_duration->setDecimals(2);
    m_duration->setSingleStep(0.5);
    m_share->setRange(1, 100);
    auto* row = new QHBoxLayout(m_frames);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(margin / 2);
    row->addWidget(m_first);
    row->addWidget(new QLabel(QStringLiteral("–")));
    row->addWidget(m_last);
    row->addStretch();
    m_form->addRow(m_title);
    m_form->addRow(m_framesLabel, m_frames);
    m_form->addRow(m_strip);
    addRow(m_repeatLabel, m_repeat);
    m_form->addRow(m_hasDuration, m_duration);
    addRow(m_shareLabel, m_share);
    m_framesLabel->setBuddy(m_first);
    for (QWidget* field :
         {static_cast<QWidget*>(m_repeat), static_cast<QWidget*>(m_duration), static_cast<QWidget*>(m_share)})
        field->setMaximumWidth(96);
    connectFields();
    connect(&media, &SequenceMedia::changed, this, [this] { show(m_action); });
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, [this] { show(m_action); });
    retranslates(this, [this] { retranslate(); });
}

void ActionForm::addRow(QLabel* label, QWidget* field)
{
    m_form->addRow(label, field);
    label->setBuddy(field);
}

void ActionForm::connectFields()
{
    const auto takeRange = [this] {
        setRange(m_first->value(), std::max(m_first->value(), m_last->value()), EditPhase::Final);
    };
    connect(m_first, &QSpinBox::valueChanged, this, takeRange);
    connect(m_last, &QSpinBox::valueChanged, this, takeRange);
    connect(m_strip, &widgets::RangeStrip::rangeEdited, this, [this](int first, int last, bool committed) {
        setRange(first, last, committed ? EditPhase::Final : EditPhase::Dragging);
    });
    connect(m_repeat, &QSpinBox::valueChanged, this, [this](int times) {
        if (m_isShowing || !m_action)
            return;
        m_action->repeat = times;
        change(tr("Change how often an action is performed"), QStringLiteral("repeat"));
    });
    const auto takeDuration = [this] {
        if (m_isShowing || !m_action)
            return;
        m_action->duration = m_hasDuration->isChecked() ? std::optional(m_duration->value()) : std::nullopt;
        change(tr("Change the duration of an action"), QStringLiteral("duration"));
    };
    connect(m_hasDuration, &QCheckBox::toggled, this, takeDuration);
    connect(m_duration, &QDoubleSpinBox::valueChanged, this, takeDuration);
    connect(m_share, &QSpinBox::valueChanged, this, [this](int percent) {
        if (m_isShowing || !m_action)
            return;
        m_action->leastShare = percent == usualShare() ? std::nullopt : std::optional(percent / 100.0);
        change(tr("Change how much of an action is played"), QStringLiteral("share"));
    });
}

void ActionForm::change(const QString& text, const QString& property, EditPhase phase)
{
    emit edited(*m_action, text, QStringLiteral("action.") + property, phase);
}

void ActionForm::setRange(int first, int last, EditPhase phase)
{
    if (m_isShowing || !m_action)
        return;
    // All frames stay all frames when the take gets longer.
    const bool isAll = first == 0 && last == m_strip->frameCount() - 1;
    m_action->frames.range =
        isAll ? std::nullopt : std::optional(FrameRange{FrameIndex(first), FrameIndex(last)});
    change(tr("Change the frames of an action"), QStringLiteral("range"), phase);
}

void ActionForm::show(const std::optional<ActionEntry>& action)
{
    const QScopedValueRollback showing(m_isShowing, true);
    m_action = action;
    setEnabled(action.has_value());
    const ActionEntry shown = action.value_or(ActionEntry());
    const bool isTake = action && !shown.frames.sequence.empty();
    m_form->setRowVisible(m_frames, isTake);
    m_form->setRowVisible(m_strip, isTake);
    m_title->setText(!action  ? tr("No card selected")
                     : isTake ? QString::fromStdString(shown.frames.sequence)
                              : tr("Label “%1”").arg(QString::fromStdString(shown.frames.label)));
    m_title->setToolTip(m_title->text());
    if (isTake)
        showRange();
    m_repeat->setValue(shown.repeat);
    m_repeat->setEnabled(!shown.duration);
    m_hasDuration->setChecked(shown.duration.has_value());
    m_duration->setEnabled(shown.duration.has_value());
    m_duration->setValue(shown.duration.value_or(usualSeconds));
    const double share = shown.leastShare.value_or(usualShare() / 100.0);
    m_share->setValue(static_cast<int>(std::lround(share * 100)));
    m_share->setEnabled(!shown.duration);
}

void ActionForm::showRange()
{
    const QString name = QString::fromStdString(m_action->frames.sequence);
    const MeshSequence* sequence = m_media.sequence(name);
    const int frames = sequence == nullptr ? 0 : static_cast<int>(sequence->frameCount());
    m_frames->setEnabled(frames > 0);
    m_strip->setEnabled(frames > 0);
    if (frames == 0)
        return;
    const auto range = m_action->frames.range.value_or(FrameRange::all(frames));
    const int first = std::clamp(static_cast<int>(range.first.value), 0, frames - 1);
    const int last = std::clamp(static_cast<int>(range.last.value), first, frames - 1);
    m_first->setRange(0, last);
    m_last->setRange(first, frames - 1);
    m_first->setValue(first);
    m_last->setValue(last);
    m_strip->setFrameCount(frames);
    m_strip->setRange(first, last);
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
    QWidget* field = m_frames->isVisibleTo(this) ? static_cast<QWidget*>(m_first) : m_repeat;
    field->setFocus(Qt::OtherFocusReason);
}

void ActionForm::retranslate()
{
    m_framesLabel->setText(tr("Frames"));
    m_first->setAccessibleName(tr("First frame"));
    m_first->setToolTip(tr("The first frame of the take that is played"));
    m_last->setAccessibleName(tr("Last frame"));
    m_last->setToolTip(tr("The last frame of the take that is played"));
    m_strip->setToolTip(tr("Drag the ends to choose the frames; ← and → move the active end by a frame"));
    m_repeatLabel->setText(tr("Times"));
    m_repeat->setAccessibleName(tr("Times"));
    m_repeat->setSuffix(tr(" ×"));
    m_repeat->setToolTip(tr("How often it is performed"));
    m_hasDuration->setText(tr("Goes on for"));
    m_hasDuration->setToolTip(tr("It goes on for a time, with any of its frames in any order"));
    m_duration->setAccessibleName(tr("Duration"));
    m_duration->setSuffix(tr(" s"));
    m_duration->setToolTip(m_hasDuration->toolTip());
    m_shareLabel->setText(tr("At least"));
    m_share->setAccessibleName(tr("Least share"));
    m_share->setSuffix(tr(" %"));
    m_share->setToolTip(tr("How much of the frames must be played; the rest may be left out at both ends to "
                           "join it better"));
    show(m_action);
}

} // namespace quadrille

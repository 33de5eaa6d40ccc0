// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/rangefield.h"

#include "editor/language/retranslate.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>

namespace quadrille {

RangeField::RangeField(const char* name, QWidget* parent)
    : QWidget(parent), m_first(new QSpinBox), m_last(new QSpinBox)
{
    m_first->setObjectName(QLatin1String(name) + QStringLiteral("First"));
    m_last->setObjectName(QLatin1String(name) + QStringLiteral("Last"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (QSpinBox* field : {m_first, m_last}) {
        field->setAlignment(Qt::AlignRight);
        field->setKeyboardTracking(false);
        row->addWidget(field, 1);
        connect(field, &QSpinBox::valueChanged, this, [this] {
            m_first->setMaximum(m_last->value());
            m_last->setMinimum(m_first->value());
            emit edited();
        });
    }
    setFocusProxy(m_first);
    retranslates(this, [this] { retranslate(); });
}

void RangeField::retranslate()
{
    m_first->setAccessibleName(tr("First frame"));
    m_last->setAccessibleName(tr("Last frame"));
}

void RangeField::setRange(const std::optional<FrameRange>& range, std::int64_t frames)
{
    const QSignalBlocker blocks[] = {QSignalBlocker(m_first), QSignalBlocker(m_last)};
    const FrameRange shown = range.value_or(FrameRange::all(std::max<std::int64_t>(frames, 1)));
    const auto first = static_cast<int>(shown.first.value);
    const auto last = static_cast<int>(shown.last.value);
    setEnabled(frames > 0);
    m_first->setRange(0, last);
    m_last->setRange(first, std::max(last, static_cast<int>(frames) - 1));
    m_first->setValue(first);
    m_last->setValue(last);
}

std::optional<FrameRange> RangeField::range() const
{
    if (m_first->value() == 0 && m_last->value() == m_last->maximum())
        return std::nullopt;
    return FrameRange{FrameIndex(m_first->value()), FrameIndex(m_last->value())};
}

} // namespace quadrille

#include "moc_rangefield.cpp"

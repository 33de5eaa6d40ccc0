// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/fieldbar.h"

#include "editor/language/retranslate.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <algorithm>
#include <cassert>

namespace quadrille {

FieldBar::FieldBar(QWidget* parent) : QWidget(parent), m_layout(new QHBoxLayout(this))
{
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(4);
    m_layout->addStretch(1);
    retranslates(this, [this] { retranslate(); });
}

void FieldBar::addField(const char* objectName, Text label, QWidget* field, Text tip,
                        [[maybe_unused]] QWidget* beside)
{
    assert(beside == nullptr);
    field->setObjectName(QLatin1String(objectName));
    // A bar gives its fields no more than they ask for, and choices less where it is narrow.
    if (auto* choice = qobject_cast<QComboBox*>(field)) {
        constexpr int fewestLetters = 8;
        choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        choice->setMinimumContentsLength(fewestLetters);
    }
    auto* text = new QLabel;
    text->setBuddy(field);
    const int end = m_layout->count() - 1; // before the stretch
    m_layout->insertWidget(end, text);
    m_layout->insertWidget(end + 1, field);
    m_layout->insertSpacing(end + 2, 8);
    m_rows.push_back({text, field, std::move(label), std::move(tip)});
    retranslate();
}

void FieldBar::setRowVisible(const QWidget* field, bool visible)
{
    const auto row = std::ranges::find(m_rows, field, &Row::field);
    assert(row != m_rows.end());
    row->label->setVisible(visible);
    row->field->setVisible(visible);
}

void FieldBar::retranslate()
{
    for (const Row& row : m_rows) {
        row.label->setText(row.text());
        row.field->setToolTip(row.tip());
    }
}

} // namespace quadrille

#include "moc_fieldbar.cpp"

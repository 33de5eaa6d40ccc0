// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/labelform.h"

#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <algorithm>
#include <cassert>

namespace quadrille {

LabelForm::LabelForm(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this))
{
    m_form->setContentsMargins(12, 4, 12, 12);
    m_form->setSpacing(8);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
}

void LabelForm::addField(const char* objectName, Text label, QWidget* field, Text tip, QWidget* beside)
{
    field->setObjectName(QLatin1String(objectName));
    QWidget* whole = field;
    if (beside != nullptr) {
        whole = new QWidget;
        auto* row = new QHBoxLayout(whole);
        row->setContentsMargins(0, 0, 0, 0);
        row->addWidget(field, 1);
        row->addWidget(beside);
    }
    QLabel* text = nullptr;
    if (label) {
        text = new QLabel;
        text->setBuddy(field);
        m_form->addRow(text, whole);
    } else {
        m_form->addRow(whole);
    }
    m_rows.push_back({text, field, whole, std::move(label), std::move(tip)});
    retranslateRows();
}

QLabel* LabelForm::addFact(const char* objectName, Text label)
{
    auto* value = new QLabel;
    value->setWordWrap(true);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    addField(objectName, std::move(label), value, {});
    return value;
}

void LabelForm::addWide(const char* objectName, QWidget* field)
{
    addField(objectName, {}, field, {});
}

void LabelForm::setRowVisible(const QWidget* field, bool visible)
{
    const auto row = std::ranges::find(m_rows, field, &Row::field);
    assert(row != m_rows.end());
    m_form->setRowVisible(row->whole, visible);
}

void LabelForm::retranslateRows()
{
    for (const Row& row : m_rows) {
        if (row.label != nullptr) {
            const QString text = row.text();
            row.label->setText(text);
            if (!text.isEmpty())
                row.field->setAccessibleName(text);
        }
        if (row.tip) {
            row.field->setToolTip(row.tip());
            if (row.label != nullptr)
                row.label->setToolTip(row.tip());
        }
    }
}

void LabelForm::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        retranslateRows();
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace quadrille

#include "moc_labelform.cpp"

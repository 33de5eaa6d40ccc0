// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/labelform.h"

#include <QEvent>
#include <QFormLayout>

namespace quadrille {

LabelForm::LabelForm(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this))
{
    m_form->setContentsMargins(12, 4, 12, 12);
    m_form->setSpacing(8);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
}

void LabelForm::addField(const char* objectName, Text label, QWidget* field, Text tip)
{
    field->setObjectName(QLatin1String(objectName));
    QLabel* text = nullptr;
    if (label) {
        text = new QLabel;
        text->setBuddy(field);
        m_form->addRow(text, field);
    } else {
        m_form->addRow(field);
    }
    m_rows.push_back({text, field, std::move(label), std::move(tip)});
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
    field->setObjectName(QLatin1String(objectName));
    m_form->addRow(field);
}

void LabelForm::setRowVisible(QWidget* field, bool visible)
{
    m_form->setRowVisible(field, visible);
}

void LabelForm::retranslateRows()
{
    for (const Row& row : m_rows) {
        if (row.label != nullptr) {
            row.label->setText(row.text());
            row.field->setAccessibleName(row.text());
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

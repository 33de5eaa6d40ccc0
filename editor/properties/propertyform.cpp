// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/propertyform.h"

#include <QEvent>
#include <QFormLayout>
#include <QLineEdit>

namespace quadrille {

PropertyForm::PropertyForm(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this))
{
    m_form->setContentsMargins(12, 4, 12, 12);
    m_form->setSpacing(8);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
}

void PropertyForm::addField(const char* objectName, Text label, QWidget* field, Text tip)
{
    auto* text = new QLabel;
    text->setBuddy(field);
    field->setObjectName(QLatin1String(objectName));
    m_form->addRow(text, field);
    m_rows.push_back({text, field, std::move(label), std::move(tip)});
    retranslateRows();
}

QLabel* PropertyForm::addFact(const char* objectName, Text label)
{
    auto* value = new QLabel;
    value->setWordWrap(true);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    addField(objectName, std::move(label), value, {});
    return value;
}

void PropertyForm::addWide(const char* objectName, QWidget* field)
{
    field->setObjectName(QLatin1String(objectName));
    m_form->addRow(field);
}

void PropertyForm::setFieldVisible(QWidget* field, bool visible)
{
    m_form->setRowVisible(field, visible);
}

void PropertyForm::showName(QLineEdit& field, const QString& name)
{
    constexpr auto shownName = "shownName";
    const bool isTyped = field.hasFocus() && field.isModified();
    if (!isTyped || field.property(shownName).toString() != name)
        field.setText(name);
    field.setProperty(shownName, name);
}

void PropertyForm::retranslateRows()
{
    for (const Row& row : m_rows) {
        row.label->setText(row.text());
        row.field->setAccessibleName(row.text());
        if (row.tip) {
            row.label->setToolTip(row.tip());
            row.field->setToolTip(row.tip());
        }
    }
}

void PropertyForm::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        retranslateRows();
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace quadrille

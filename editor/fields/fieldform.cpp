// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/fieldform.h"

#include <QCoreApplication>

namespace quadrille {

QString historyText(QString label)
{
    return QCoreApplication::translate("quadrille::FieldForm", "Set “%1”")
        .arg(label.remove(QLatin1Char('&')));
}

QComboBox* makeChoiceField()
{
    auto* field = new QComboBox;
    field->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    field->setFocusPolicy(Qt::StrongFocus);
    return field;
}

} // namespace quadrille

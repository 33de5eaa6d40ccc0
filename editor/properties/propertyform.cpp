// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/propertyform.h"

#include <QLineEdit>

namespace quadrille {

void PropertyForm::showName(QLineEdit& field, const QString& name)
{
    constexpr auto shownName = "shownName";
    const bool isTyped = field.hasFocus() && field.isModified();
    if (!isTyped || field.property(shownName).toString() != name)
        field.setText(name);
    field.setProperty(shownName, name);
}

} // namespace quadrille

#include "moc_propertyform.cpp"

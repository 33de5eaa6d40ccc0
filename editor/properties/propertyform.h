// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/labelform.h"

class QLineEdit;

namespace quadrille {

/// A page of properties of an entry.
class PropertyForm : public LabelForm
{
    Q_OBJECT

public:
    using LabelForm::LabelForm;

    /// Shows the entry of a name; the page reads its values anew.
    virtual void show(const QString& name) = 0;

protected:
    /// Shows the name of an entry; what is being typed stays while the entry keeps its name.
    static void showName(QLineEdit& field, const QString& name);
};

} // namespace quadrille

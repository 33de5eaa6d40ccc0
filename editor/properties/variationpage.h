// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/properties/propertyform.h"

class QComboBox;
class QLineEdit;
class QPushButton;

namespace quadrille {

struct EditorContext;

/// What variations are learned from and what is drawn, in short. Their workspace edits it.
class VariationPage : public PropertyForm
{
    Q_OBJECT

public:
    explicit VariationPage(EditorContext& context);

    void show(const QString& name) override;
    using QWidget::show;

private:
    void retranslate() override;

    EditorContext& m_context;
    QString m_name;
    QLineEdit* m_nameField;
    QComboBox* m_character;
    QLabel* m_takes = nullptr;
    QLabel* m_samples = nullptr;
    QPushButton* m_open;
};

} // namespace quadrille

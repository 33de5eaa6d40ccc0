// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/labelform.h"

class QHBoxLayout;

namespace quadrille {

/// Fields one behind the other, each behind its label: a form of FieldForm for bars.
class FieldBar : public QWidget
{
    Q_OBJECT

public:
    using Text = LabelForm::Text;

    explicit FieldBar(QWidget* parent = nullptr);

    /// The bar owns the field. \param beside  null: bars have no buttons behind their fields.
    void addField(const char* objectName, Text label, QWidget* field, Text tip, QWidget* beside = nullptr);
    /// \pre The field was added.
    void setRowVisible(const QWidget* field, bool visible);

private:
    struct Row
    {
        QLabel* label;
        QWidget* field;
        Text text;
        Text tip;
    };
    void retranslate();

    QHBoxLayout* m_layout;
    std::vector<Row> m_rows;
};

} // namespace quadrille

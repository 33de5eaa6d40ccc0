// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "model/project/document/variationentry.h"

#include <QLabel>

namespace quadrille {

class PartCurveTool;

/// What the selected part hangs on and which curves bound it, or the facts of the selected curve.
class PartForm : public LabelForm
{
    Q_OBJECT

public:
    explicit PartForm(PartCurveTool& tool, QWidget* parent = nullptr);

protected:
    void retranslate() override;

private:
    void addParent();
    void addCurve(std::size_t which, FieldRows<PartEntry, LabelForm>::Row row);
    void refresh();
    void showCurve(const PartCurveEntry* curve);

    PartCurveTool& m_tool;
    QLabel* m_title;
    FieldForm<PartEntry, LabelForm> m_fields;
    QLabel* m_points;
    QLabel* m_length;
};

} // namespace quadrille

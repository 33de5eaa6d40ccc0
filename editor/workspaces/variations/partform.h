// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <array>

class QComboBox;
class QFormLayout;
class QLabel;

namespace quadrille {

class PartCurveTool;

/// What the selected part hangs on and which curves bound it, or the facts of the selected curve.
class PartForm : public QWidget
{
    Q_OBJECT

public:
    explicit PartForm(PartCurveTool& tool, QWidget* parent = nullptr);

private:
    void retranslate();
    void refresh();
    void setParentPart(const QString& name);
    void setCurve(int which, const QString& name);

    PartCurveTool& m_tool;
    QFormLayout* m_form;
    QLabel* m_title;
    QComboBox* m_parent;
    std::array<QComboBox*, 2> m_curves;
    QLabel* m_points;
    QLabel* m_length;
};

} // namespace quadrille

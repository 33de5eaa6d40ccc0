// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/evaluationresults.h"
#include "editor/workspaces/appearance/showntexture.h"

#include <QWidget>

class QComboBox;
class QPushButton;

namespace quadrille {

namespace widgets {
class ElidedLabel;
class LineChart;
} // namespace widgets

/// What so many components give: the share of the variance that they explain, and where that was evaluated,
/// how near textures and pictures come. The marker is the number that is used.
class QualityPanel : public QWidget
{
    Q_OBJECT

public:
    explicit QualityPanel(ShownTexture& shown, QWidget* parent = nullptr);

private:
    void retranslate();
    void refresh();
    void showVariance();
    void showEvaluation();
    void compute();
    /// The name of the evaluation that is chosen; empty for the variance.
    QString evaluation() const;
    const EvaluationResults::State* evaluationState() const;

    ShownTexture& m_shown;
    QComboBox* m_what;
    QPushButton* m_compute;
    widgets::ElidedLabel* m_state;
    widgets::LineChart* m_chart;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <array>

class QPushButton;

namespace quadrille {

class GraphExplorer;

namespace widgets {
class LineChart;
} // namespace widgets

/// Density, edges and mean path costs of both graphs against α. They are computed once somebody looks; of
/// many frames once somebody wants them.
class GraphChartsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit GraphChartsPanel(GraphExplorer& explorer, QWidget* parent = nullptr);

    /// A line at α, while it moves.
    void setAlpha(double alpha);

signals:
    /// The marker of a chart was dragged.
    void alphaEdited(double alpha, bool committed);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void refresh();
    void retranslate();

    GraphExplorer& m_explorer;
    std::array<widgets::LineChart*, 3> m_charts{}; ///< density, edges, mean cost
    QPushButton* m_compare;
};

} // namespace quadrille

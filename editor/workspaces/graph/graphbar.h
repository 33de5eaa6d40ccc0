// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <array>

class QComboBox;
class QLabel;

namespace quadrille {

class GraphExplorer;
struct EditorContext;

namespace widgets {
class LogSlider;
} // namespace widgets

/// Above the map: whose graph it is, α, and what both graphs amount to, which follows α while it moves.
class GraphBar : public QWidget
{
    Q_OBJECT

public:
    /// The ends of the slider of α.
    static constexpr double leastAlpha = 1e-4;
    static constexpr double greatestAlpha = 1;

    GraphBar(EditorContext& context, GraphExplorer& explorer, QWidget* parent = nullptr);

    /// The character whose graph is shown.
    QString character() const;
    widgets::LogSlider& alpha() { return *m_alpha; }

public slots:
    /// Sets α in the project. \param committed  false while it is dragged.
    void editAlpha(double alpha, bool committed);

signals:
    void characterChosen();

private:
    struct Row
    {
        QLabel* name;
        QLabel* edges;
        QLabel* density;
        QLabel* cost;
    };
    QWidget* makeTable();
    void followDocument();
    void showGraphs();
    void showCurve();
    void retranslate();

    EditorContext& m_context;
    GraphExplorer& m_explorer;
    QComboBox* m_character;
    QLabel* m_alphaLabel;
    widgets::LogSlider* m_alpha;
    std::array<QLabel*, 3> m_headings{};
    std::array<Row, 2> m_rows{}; ///< Essential, motion
};

} // namespace quadrille

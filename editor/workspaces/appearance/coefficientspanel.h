// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/appearance/showntexture.h"

#include <QWidget>
#include <vector>

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;

namespace quadrille {

/// A slider for each coefficient of the texture that is looked at, in standard deviations. The first ones are
/// shown, the rest when the user asks.
class CoefficientsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit CoefficientsPanel(ShownTexture& shown, QWidget* parent = nullptr);

private:
    struct Row
    {
        ShownTexture::Component component;
        QLabel* label;
        QSlider* slider;
        QDoubleSpinBox* number;
    };

    void arrangeWidgets();
    void retranslate();
    void refresh();
    void makeRows();
    void addRow(const ShownTexture::Component& component);
    void showValues();
    std::vector<ShownTexture::Component> wantedRows() const;

    ShownTexture& m_shown;
    QLabel* m_frame;
    QLabel* m_empty;
    QWidget* m_content;
    QGridLayout* m_grid;
    std::vector<Row> m_rows;
    QPushButton* m_reset;
    QPushButton* m_mean;
    QPushButton* m_more;
    bool m_showsAll = false;
    bool m_isShowing = false;
};

} // namespace quadrille

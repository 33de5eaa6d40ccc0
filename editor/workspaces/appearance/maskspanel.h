// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/appearance/maskcanvas.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QListWidget;
class QSlider;
class QToolButton;

namespace quadrille {

/// The textures that are to be completed, and the brush that marks what is missing of them.
class MasksPanel : public QWidget
{
    Q_OBJECT

public:
    explicit MasksPanel(ShownTexture& shown, TextureComparison& comparison, QWidget* parent = nullptr);

private:
    void makeActions();
    void arrangeWidgets();
    void retranslate();
    void refresh();
    void refreshActions();
    QString stateText() const;

    ShownTexture& m_shown;
    MaskCanvas* m_canvas;
    QLabel* m_sentence;
    QLabel* m_toolLabel;
    QComboBox* m_tool;
    QLabel* m_sizeLabel;
    QSlider* m_size;
    QListWidget* m_list;
    QLabel* m_state;
    bool m_isShowing = false;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/appearance/showntexture.h"

#include <QWidget>
#include <array>

class QLabel;
class QPushButton;

namespace quadrille {

class SliderField;

/// Two captured frames and a weight: the texture between them by the model, to be compared with a linear
/// blend.
class BetweenPanel : public QWidget
{
    Q_OBJECT

public:
    explicit BetweenPanel(ShownTexture& shown, QWidget* parent = nullptr);

private:
    struct End
    {
        QLabel* label;
        QLabel* frame;
        QPushButton* take; ///< the frame that is shown becomes it
        QPushButton* show;
    };

    void arrangeWidgets();
    void retranslate();
    void refresh();
    const std::optional<NamedFrame>& frameOf(std::size_t end) const;

    ShownTexture& m_shown;
    QLabel* m_sentence;
    std::array<End, 2> m_ends;
    QLabel* m_weightLabel;
    SliderField* m_weight;
    QLabel* m_note;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace quadrille {

class CurrentAnimation;

/// Which animation is worked on, and how far its search is.
class AnimationBar : public QWidget
{
    Q_OBJECT

public:
    explicit AnimationBar(CurrentAnimation& animation, QWidget* parent = nullptr);

private:
    void makeActions();
    void refreshNames();
    void refreshState();
    QString stateText() const;
    QString resultText() const;

    CurrentAnimation& m_animation;
    QComboBox* m_names;
    QLabel* m_state;
    QToolButton* m_stop;
    QToolButton* m_solve;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace quadrille {

class CurrentVariation;

/// Which variations are worked on, and how far they are.
class VariationBar : public QWidget
{
    Q_OBJECT

public:
    explicit VariationBar(CurrentVariation& variation, QWidget* parent = nullptr);

private:
    void makeActions();
    void refresh();
    void refreshState();

    CurrentVariation& m_variation;
    QComboBox* m_names;
    QToolButton* m_learn;
    QToolButton* m_stop;
    QLabel* m_state;
};

} // namespace quadrille

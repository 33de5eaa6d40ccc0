// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/appearance/currentappearance.h"

#include <QPointer>
#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QToolButton;

namespace quadrille {

/// Which model of appearance is worked on, its settings, how far it is, and what computes it.
class AppearanceBar : public QWidget
{
    Q_OBJECT

public:
    explicit AppearanceBar(CurrentAppearance& appearance, QWidget* parent = nullptr);

private:
    void makeActions();
    void makeFields();
    void arrangeWidgets();
    void retranslate();
    void refresh();
    void refreshState();
    void showProgress();
    QString stateText() const;
    void edit(const QString& what, const char* property, const CurrentAppearance::Edit& edit);

    CurrentAppearance& m_appearance;
    QComboBox* m_names;
    QDoubleSpinBox* m_components = nullptr;
    QDoubleSpinBox* m_warps = nullptr;
    QComboBox* m_flow;
    QComboBox* m_varied;
    QLabel* m_componentsLabel;
    QLabel* m_warpsLabel;
    QLabel* m_flowLabel;
    QLabel* m_variedLabel;
    QToolButton* m_build = nullptr;
    QToolButton* m_stop = nullptr;
    QProgressBar* m_progress;
    QLabel* m_state;
    QPointer<Job> m_job; ///< whose progress is followed
    bool m_isShowing = false;
};

} // namespace quadrille

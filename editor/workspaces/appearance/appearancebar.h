// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldbar.h"
#include "editor/fields/fieldform.h"
#include "editor/workspaces/appearance/currentappearance.h"

#include <QPointer>

class QComboBox;
class QProgressBar;
class QToolButton;

namespace quadrille {

namespace widgets {
class ElidedLabel;
} // namespace widgets

/// Which model of appearance is worked on, its settings, how far it is, and what computes it.
class AppearanceBar : public QWidget
{
    Q_OBJECT

public:
    explicit AppearanceBar(CurrentAppearance& appearance, QWidget* parent = nullptr);

private:
    void makeActions();
    void arrangeWidgets();
    void retranslate();
    void refresh();
    void refreshState();
    void showProgress();
    QString stateText() const;

    CurrentAppearance& m_appearance;
    QComboBox* m_names;
    FieldBar* m_bar;
    FieldForm<AppearanceEntry, FieldBar> m_fields;
    QToolButton* m_build = nullptr;
    QToolButton* m_stop = nullptr;
    QProgressBar* m_progress;
    widgets::ElidedLabel* m_state;
    QPointer<Job> m_job; ///< whose progress is followed
};

} // namespace quadrille

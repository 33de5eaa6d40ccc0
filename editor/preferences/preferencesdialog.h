// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QSpinBox;
class QTabWidget;

namespace quadrille {

struct EditorContext;

/// What the user prefers in every project; applied as it is changed.
class PreferencesDialog : public QDialog
{
    Q_OBJECT

public:
    explicit PreferencesDialog(EditorContext& context, QWidget* parent = nullptr);

private:
    QWidget* makeGeneral();
    void retranslate();

    EditorContext& m_context;
    QTabWidget* m_tabs;
    QFormLayout* m_form = nullptr;
    QComboBox* m_theme;
    QComboBox* m_language;
    QSpinBox* m_autosave;
    QSpinBox* m_history;
    QCheckBox* m_loops;
    QComboBox* m_mouse;
};

} // namespace quadrille

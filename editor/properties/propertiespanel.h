// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QStackedWidget;

namespace quadrille {

class PropertyForm;
struct EditorContext;

/// Content of the Properties dock: the values of what is selected, applied as they are edited.
class PropertiesPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PropertiesPanel(EditorContext& context, QWidget* parent = nullptr);

private:
    void refresh();
    QString summary() const;

    EditorContext& m_context;
    QLabel* m_title;
    QLabel* m_several;
    QStackedWidget* m_pages;
    PropertyForm* m_project;
    PropertyForm* m_character;
    PropertyForm* m_sequence;
    PropertyForm* m_export;
    PropertyForm* m_animation;
    PropertyForm* m_variation;
    PropertyForm* m_broken;
};

} // namespace quadrille

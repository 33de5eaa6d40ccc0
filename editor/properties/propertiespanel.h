// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/changeevent.h"

#include <QWidget>
#include <map>

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
    /// The page of what is selected.
    PropertyForm* pageOf(const EntryRef& entry) const;
    QString summary() const;

    EditorContext& m_context;
    QLabel* m_title;
    QLabel* m_several;
    QStackedWidget* m_pages;
    PropertyForm* m_project; ///< where nothing else is shown
    std::map<Section, PropertyForm*> m_entries;
};

} // namespace quadrille

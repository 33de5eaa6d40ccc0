// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QObject>
#include <functional>
#include <utility>
#include <vector>

class QAction;
class QMainWindow;
class QMenu;

namespace quadrille {

struct EditorContext;

/// The menus of the window: which action of the registry stands where.
class Menus : public QObject
{
    Q_OBJECT

public:
    /// \param docks what shows and hides the docks, for the View menu.
    Menus(EditorContext& context, const QList<QAction*>& docks, QMainWindow& window);

private:
    QMenu* addMenu(std::function<QString()> title, const QStringList& actions);
    void addLanguages();
    void retranslate();

    EditorContext& m_context;
    QMainWindow& m_window;
    std::vector<std::pair<QMenu*, std::function<QString()>>> m_titles;
};

} // namespace quadrille

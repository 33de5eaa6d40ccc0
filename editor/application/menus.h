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

/// The menus of the window: which action of the registry stands where. A menu has what is used together; what
/// there is more of lies one step deeper.
class Menus : public QObject
{
    Q_OBJECT

public:
    Menus(EditorContext& context, QMainWindow& window);

    /// Panels and layouts of the workspace are put in here by who knows them.
    QMenu& view() { return *m_view; }
    /// The texts of a menu's entries begin with one capital letter; so does this. \param name  its object
    /// name. \param actions  ids; an empty one is a separator.
    QMenu* addSubmenu(QMenu& menu, const char* name, std::function<QString()> title,
                      const QStringList& actions = {});

private:
    QMenu* addMenu(const char* name, std::function<QString()> title, const QStringList& actions);
    void fill(QMenu& menu, const QStringList& actions);
    /// \param what  an action is about, told behind its text while the menu is open; may give nothing.
    void nameWhileOpen(QMenu& menu, const char* id, std::function<QString()> what);
    void addFile();
    void addView();
    void addGraph();
    void addAnimate();
    void addVariations();
    void addAppearance();
    void addTransfer();
    void addLive();
    void addLanguages();
    void retranslate();

    EditorContext& m_context;
    QMainWindow& m_window;
    QMenu* m_view = nullptr;
    std::vector<std::pair<QMenu*, std::function<QString()>>> m_titles;
};

} // namespace quadrille

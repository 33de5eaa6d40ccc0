// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QObject>
#include <functional>
#include <vector>

namespace quadrille {

class Settings;

/// Every action of the program by a name of its own: menus, tool bars, the palette and the shortcut editor
/// take them from here. Texts are functions, so that they follow the language.
class ActionRegistry : public QObject
{
    Q_OBJECT

public:
    using Text = std::function<QString()>;
    struct Entry
    {
        QString id; ///< also the action's object name, e.g. "file.save"
        Text group; ///< "File", "Playback", … as the palette and the shortcut editor show it
        Text text;
        Text tip; ///< one sentence; may be empty
        QString icon;
        QList<QKeySequence> shortcuts;
    };

    /// \param settings  hold the user's shortcuts; they outlive the registry.
    explicit ActionRegistry(Settings& settings, QObject* parent = nullptr);

    /// Makes an action that runs `run` when triggered. The registry owns it. \pre No action has its id yet.
    QAction* add(Entry entry, std::function<void()> run);
    /// Makes an action that can be on or off. \param checked  how it begins; `run` is not called for that,
    /// only when it is toggled later.
    QAction* addToggle(Entry entry, bool checked, std::function<void(bool)> run);
    /// \pre There is one.
    QAction* action(const QString& id) const;
    /// In the order in which they were added.
    QList<QAction*> actions() const;
    /// Translated. \pre The action is of this registry; so for the next two.
    QString group(const QAction* action) const;
    /// Those that it was made with, whatever the user made of them.
    QList<QKeySequence> ownShortcuts(const QAction* action) const;
    /// Gives an action other shortcuts and remembers them.
    void setShortcuts(QAction* action, const QList<QKeySequence>& shortcuts);
    /// Puts the texts in again, in the language that is installed now.
    void retranslate();

private:
    struct Item
    {
        Entry entry;
        QAction* action;
    };
    const Item& item(const QAction* action) const;
    QAction* make(Entry entry);
    static void translate(const Item& item);

    Settings& m_settings;
    std::vector<Item> m_items;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QPointer>
#include <vector>

class QAction;
class QLabel;
class QLineEdit;
class QListWidget;

namespace quadrille::widgets {

/// Finds any action by typing parts of its name, and runs it. Actions run last come first.
class ActionPalette : public QDialog
{
    Q_OBJECT

public:
    struct Entry
    {
        QAction* action;
        QString group; ///< "File", "Playback", …
    };

    explicit ActionPalette(QWidget* parent = nullptr);

    /// Shows the palette over its parent with these actions. Returns at once; the action runs when it is
    /// chosen. \pre The actions live as long as it is shown.
    void ask(const std::vector<Entry>& entries);
    /// How well typed text fits a name; 0: not at all. Every typed word must be in it, whole words and their
    /// beginnings count more.
    static int score(const QString& typed, const QString& name);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refill();
    void run();
    void retranslate();

    std::vector<Entry> m_entries;
    QList<QPointer<QAction>> m_recent; ///< last run first
    QLineEdit* m_field;
    QListWidget* m_list;
    QLabel* m_nothing;
};

} // namespace quadrille::widgets

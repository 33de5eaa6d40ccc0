// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace quadrille {

class Settings;

/// What is seen before a project is open: how to begin, and what was open before.
class WelcomePage : public QWidget
{
    Q_OBJECT

public:
    explicit WelcomePage(Settings& settings, QWidget* parent = nullptr);

signals:
    /// An action of the registry shall run, e.g. "file.open".
    void actionAsked(const QString& id);
    void projectAsked(const QString& file);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QPushButton* addButton(const char* action, const char* icon);
    void showRecent();
    void forgetCurrent();
    void retranslate();

    Settings& m_settings;
    QLabel* m_title;
    QLabel* m_lead;
    QPushButton* m_sample;
    QPushButton* m_open;
    QPushButton* m_import;
    QLabel* m_recentTitle;
    QListWidget* m_recent;
};

} // namespace quadrille

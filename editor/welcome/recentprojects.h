// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QListWidget>

namespace quadrille {

class Settings;

/// The projects that were open last, each with a picture of how it was left. As high as it needs to be, for a
/// page that scrolls. Those that are not there any more say so, and can be taken out of the list.
class RecentProjects : public QListWidget
{
    Q_OBJECT

public:
    enum Role
    {
        FileRole = Qt::UserRole, ///< QString
        MissingRole,             ///< bool
    };

    explicit RecentProjects(Settings& settings, QWidget* parent = nullptr);

    /// Looks again which projects there are, and at their pictures.
    void refresh();
    /// Takes a project out of the list; its file stays.
    void forget(const QString& file);

signals:
    void projectRequested(const QString& file);
    /// Somebody wants a project that is not there.
    void missingRequested(const QString& file);
    /// There may be others now.
    void refreshed();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void ask(const QListWidgetItem* item);
    void showMenu(const QPoint& position);
    void fitHeight();

    Settings& m_settings;
};

} // namespace quadrille

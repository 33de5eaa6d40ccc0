// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QMenu>

namespace quadrille {

class Settings;

/// The projects that were open last.
class RecentMenu : public QMenu
{
    Q_OBJECT

public:
    explicit RecentMenu(Settings& settings, QWidget* parent = nullptr);

signals:
    void projectRequested(const QString& file);

private:
    void refill();

    Settings& m_settings;
};

} // namespace quadrille

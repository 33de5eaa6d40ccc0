// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/recentmenu.h"

#include "editor/context/settings.h"
#include "editor/language/menutext.h"
#include "editor/language/retranslate.h"

#include <QFileInfo>

namespace quadrille {

RecentMenu::RecentMenu(Settings& settings, QWidget* parent) : QMenu(parent), m_settings(settings)
{
    setObjectName(QStringLiteral("recentMenu"));
    setToolTipsVisible(true);
    connect(&settings, &Settings::recentProjectsChanged, this, &RecentMenu::refill);
    retranslates(this, [this] { refill(); });
}

void RecentMenu::refill()
{
    clear();
    const QStringList files = m_settings.recentProjects();
    for (const QString& file : files) {
        const QFileInfo info(file);
        QAction* action =
            addAction(menuText(info.completeBaseName()), this, [this, file] { emit projectRequested(file); });
        action->setToolTip(file);
        action->setEnabled(info.exists());
    }
    setEnabled(!files.isEmpty());
    if (files.isEmpty())
        return;
    addSeparator();
    addAction(tr("Forget these"), this, [this, files] {
        for (const QString& file : files)
            m_settings.removeRecentProject(file);
    });
}

} // namespace quadrille

#include "moc_recentmenu.cpp"

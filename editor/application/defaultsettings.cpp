// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/defaultsettings.h"

#include "editor/context/settings.h"
#include "editor/language/languagemanager.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>
#include <algorithm>

namespace quadrille {

namespace {

constexpr int secondsToAnswer = 30;

struct SettingsTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::DefaultSettings)
};

QString asideOf(const QString& path)
{
    return path + QStringLiteral(".aside");
}

bool canBeAnswered()
{
    const QString platform = QGuiApplication::platformName();
    return platform != QLatin1String("offscreen") && !platform.startsWith(QLatin1String("minimal"));
}

/// Counts down on a button, and presses it at the end.
void pressAfterWaiting(QPushButton& button)
{
    auto* timer = new QTimer(&button);
    button.setText(SettingsTexts::tr("Default settings (%1)").arg(secondsToAnswer));
    QObject::connect(timer, &QTimer::timeout, &button, [&button, left = secondsToAnswer]() mutable {
        if (--left == 0)
            button.click();
        else
            button.setText(SettingsTexts::tr("Default settings (%1)").arg(left));
    });
    timer->start(1000);
}

} // namespace

QString checkSettings()
{
    return QSettings().status() == QSettings::FormatError ? takeDefaultSettings() : QString();
}

bool askForDefaultSettings(int failedStarts)
{
    if (!canBeAnswered())
        return true;
    LanguageManager languages;
    languages.setLanguage(Settings().language());
    QMessageBox box(
        QMessageBox::Question, SettingsTexts::tr("Quadrille did not start"),
        SettingsTexts::tr("The last %n start(s) of Quadrille failed. Start with default settings?", nullptr,
                          failedStarts));
    box.setObjectName(QStringLiteral("startOffer"));
    box.setInformativeText(
        SettingsTexts::tr(
            "Shortcuts, theme and the arrangement of windows are as they were at first then. Yours are put "
            "aside as %1.")
            .arg(asideOf(QSettings().fileName())));
    QPushButton* defaults = box.addButton(QString(), QMessageBox::AcceptRole);
    defaults->setObjectName(QStringLiteral("startDefaults"));
    QPushButton* before = box.addButton(SettingsTexts::tr("Start as before"), QMessageBox::RejectRole);
    before->setObjectName(QStringLiteral("startAsBefore"));
    box.setDefaultButton(defaults);
    box.setEscapeButton(before);
    pressAfterWaiting(*defaults);
    box.exec();
    return box.clickedButton() == defaults;
}

QString takeDefaultSettings()
{
    const QString language = Settings().language();
    QStringList recent = Settings().recentProjects();
    std::reverse(recent.begin(), recent.end()); // the last one that is added comes first
    QSettings settings;
    settings.sync();
    QString aside = asideOf(settings.fileName());
    QFile::remove(aside);
    QFile::copy(settings.fileName(), aside);
    settings.clear();
    settings.sync();
    if (!language.isEmpty())
        Settings().setLanguage(language);
    for (const QString& project : recent)
        Settings().addRecentProject(project);
    const QString sessions =
        QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/sessions");
    QDir(asideOf(sessions)).removeRecursively();
    QDir().rename(sessions, asideOf(sessions));
    return aside;
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/defaultsettings.h"
#include "editor/application/memory.h"
#include "editor/application/startguard.h"
#include "editor/context/settings.h"
#include "editor/mainwindow.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/vtkview.h"

#include <QApplication>
#include <QCommandLineParser>

int main(int argc, char** argv)
{
    using namespace quadrille;
    keepMemoryTight();
    // Under Wayland VTK's context sharing needs XWayland.
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "xcb");
    widgets::VtkView::setDefaultFormat();
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("Quadrille"));
    QApplication::setApplicationName(QStringLiteral("quadrille"));
    QApplication::setApplicationVersion(QStringLiteral(QUADRILLE_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("quadrille"));
    widgets::Theme::instance().install();
    QApplication::setWindowIcon(widgets::icons::application());

    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Editor for 4D performance capture"));
    parser.addHelpOption();
    parser.addVersionOption();
    const QCommandLineOption sample(QStringLiteral("sample"), QStringLiteral("Open the built-in sample."));
    parser.addOption(sample);
    parser.addPositionalArgument(QStringLiteral("files"),
                                 QStringLiteral("A project, or mesh sequences (files, folders or patterns)."),
                                 QStringLiteral("[PROJECT | SEQUENCE…]"));
    parser.process(application);

    QString aside = checkSettings(); // before all that reads settings: Qt tells once that it could not
    StartGuard guard(settingsFolder());
    if (guard.failedStarts() >= StartGuard::patience && askForDefaultSettings(guard.failedStarts()))
        aside = takeDefaultSettings();
    widgets::Theme::instance().setMode(Settings().theme());
    MainWindow window;
    if (const QString language = qEnvironmentVariable("QUADRILLE_LANGUAGE"); !language.isEmpty())
        window.context().languages.setLanguage(
            language); // for this run; "x-pseudo" shows what is not translated
    window.show();
    guard.watch(window);
    if (!aside.isEmpty())
        window.tellPutAside(aside);
    window.offerRecovery();
    if (parser.isSet(sample))
        window.openSample();
    if (!parser.positionalArguments().isEmpty())
        window.open(parser.positionalArguments());
    return QApplication::exec();
}

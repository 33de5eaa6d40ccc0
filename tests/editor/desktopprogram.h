// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "desktopwindows.h"

#include <QDir>
#include <QProcess>
#include <QProcessEnvironment>
#include <algorithm>

namespace quadrille::test {

/// The program itself, with settings of its own.
class DesktopProgram
{
public:
    explicit DesktopProgram(const QString& folder)
    {
        m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_environment = QProcessEnvironment::systemEnvironment();
        for (const char* place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) {
            QDir(folder).mkpath(place);
            m_environment.insert(place, QDir(folder).filePath(place));
        }
    }
    void setScale(const QString& factor) { m_environment.insert("QT_SCALE_FACTOR", factor); }
    void start(const QStringList& arguments = {})
    {
        m_process.setProcessEnvironment(m_environment);
        m_process.start(QUADRILLE_EDITOR, arguments);
    }
    /// The first window of the program whose title fits.
    DesktopWindow window(const QString& title = "Quadrille") const
    {
        for (const DesktopWindow& window : windowsOf(m_process.processId())) {
            if (window.title.contains(title))
                return window;
        }
        return {};
    }
    bool isRunning() const { return m_process.state() == QProcess::Running; }
    /// Not so while it is only about to run.
    bool hasEnded() const { return m_process.state() == QProcess::NotRunning; }
    void kill()
    {
        m_process.kill();
        m_process.waitForFinished();
    }
    QProcess& process() { return m_process; }
    /// Of starts that are not over.
    int markers() const
    {
        const QStringList all = QDir(settings()).entryList({"starting-*"});
        return static_cast<int>(
            std::ranges::count_if(all, [](const QString& name) { return !name.contains('.'); }));
    }
    QString settings() const { return m_environment.value("XDG_CONFIG_HOME") + "/Quadrille"; }

private:
    QProcess m_process;
    QProcessEnvironment m_environment;
};

} // namespace quadrille::test

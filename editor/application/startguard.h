// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QLockFile>
#include <QObject>
#include <QStringList>
#include <memory>

class QWidget;
class QWindow;

namespace quadrille {

/// Knows whether the last starts of the program failed. Each start leaves a marker in the settings' folder,
/// which goes once its window is shown and answers, or at an orderly end; what stays of a program that does
/// not run any more is a start that failed.
class StartGuard : public QObject
{
    Q_OBJECT

public:
    /// After so many failed starts in a row other settings should be offered.
    static constexpr int patience = 3;

    /// \param folder  where the markers are; made when it is not there.
    explicit StartGuard(const QString& folder, QObject* parent = nullptr);
    /// Succeeds, where that is not known yet: the program ended in order.
    ~StartGuard() override;

    /// Starts in a row before this one that failed.
    int failedStarts() const { return static_cast<int>(m_failed.size()); }
    /// Waits until a window is shown and there was nothing left to be done; then this start has succeeded.
    /// \pre The window has a handle: it was shown, or made native.
    void watch(QWidget& window);
    /// Forgets this start and those that failed before.
    void succeed();

signals:
    /// Told at most once.
    void succeeded();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void followExposure(const QWindow& window);

    QString m_marker;
    std::unique_ptr<QLockFile> m_lock; ///< held for as long as the program runs
    QStringList m_failed;              ///< markers of starts that failed
    bool m_isExposed = false;
};

/// The folder of the settings file.
QString settingsFolder();

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QObject>
#include <QTimer>
#include <algorithm>

namespace quadrille::test {

/// An application that measures its event handlers.
class MeasuredApplication : public QApplication
{
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override
    {
        const bool paints = event->type() == QEvent::UpdateRequest || event->type() == QEvent::Paint;
        QElapsedTimer clock;
        clock.start();
        const bool result = QApplication::notify(receiver, event);
        qint64& longest = paints ? m_longestPainting : m_longestOther;
        longest = std::max(longest, clock.elapsed());
        return result;
    }

    void reset() { m_longestPainting = m_longestOther = 0; }
    /// Milliseconds of the slowest handler that draws, which without a graphics card is the renderer's.
    qint64 longestPainting() const { return m_longestPainting; }
    /// Milliseconds of the slowest of all others.
    qint64 longestOther() const { return m_longestOther; }

private:
    qint64 m_longestPainting = 0;
    qint64 m_longestOther = 0;
};

/// Measures how late the interface thread handles events: asks for one every millisecond and keeps the
/// longest wait.
class EventProbe : public QObject
{
public:
    EventProbe()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        m_timer.setInterval(1);
        connect(&m_timer, &QTimer::timeout, this, [this] {
            const qint64 now = m_clock.restart();
            m_longest = std::max(m_longest, now - 1);
            ++m_events;
            m_late += now > limitMilliseconds ? 1 : 0;
        });
    }

    void start()
    {
        m_longest = m_late = m_events = 0;
        m_clock.start();
        m_timer.start();
    }
    void stop() { m_timer.stop(); }
    /// Milliseconds.
    qint64 longest() const { return m_longest; }
    /// Events that waited longer than the editor allows itself.
    qint64 late() const { return m_late; }
    qint64 events() const { return m_events; }

    static constexpr qint64 limitMilliseconds = 50;

private:
    QTimer m_timer;
    QElapsedTimer m_clock;
    qint64 m_longest = 0;
    qint64 m_late = 0;
    qint64 m_events = 0;
};

} // namespace quadrille::test

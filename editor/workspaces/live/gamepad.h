// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/live/livesteering.h"

#include <QObject>
#include <QString>
#include <memory>

namespace quadrille {

/// The first gamepad that is there, by SDL. It may come and go at any time.
///
/// The left stick steers what goes to the sides and forward, the right one's height the third parameter; A
/// jumps, the shoulder buttons go from space to space, Start records.
class Gamepad : public QObject
{
    Q_OBJECT

public:
    explicit Gamepad(QObject* parent = nullptr);
    ~Gamepad() override;

    /// Reads it anew: emits what happened since the last time. Some microseconds; looks for another one where
    /// there is none.
    void poll();
    bool isConnected() const;
    /// What it calls itself; empty without one.
    QString name() const;
    /// Sticks, without what they rest at. Idle without one.
    const SteeringState& state() const { return m_state; }

signals:
    /// One came, or the one that was there was pulled out.
    void connectedChanged();
    void jumpPressed();
    /// \param by  1 or −1.
    void spacePressed(int by);
    void recordPressed();

private:
    struct Private;
    void connectFirst();
    void press(int button);

    std::unique_ptr<Private> d;
    SteeringState m_state;
};

} // namespace quadrille

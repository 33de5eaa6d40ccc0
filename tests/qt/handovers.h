// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QEvent>

namespace quadrille::test {

#ifdef __SANITIZE_THREAD__
/// Tells the thread sanitizer that all that was handed over until now has arrived in this thread.
void takeHandovers();

/// An application that does so before each event.
template <typename Application>
class Observed : public Application
{
public:
    using Application::Application;
    bool notify(QObject* receiver, QEvent* event) override
    {
        takeHandovers();
        return Application::notify(receiver, event);
    }
};
#else
template <typename Application>
using Observed = Application;
#endif

} // namespace quadrille::test

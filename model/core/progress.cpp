// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/progress.h"

#include "model/core/error.h"

#include <algorithm>
#include <mutex>

namespace quadrille {

struct Progress::Shared
{
    CancelToken token;
    Callback callback;
    std::mutex mutex;
    double reached = -1;
};

Progress::Progress(CancelToken token, Callback callback) : m_shared(std::make_shared<Shared>())
{
    m_shared->token = std::move(token);
    m_shared->callback = std::move(callback);
}

void Progress::report(double fraction) const
{
    if (!m_shared)
        return;
    if (m_shared->token.isCancelled())
        throw Error(ErrorCode::Cancelled);
    if (!m_shared->callback)
        return;
    const double overall = m_from + (m_to - m_from) * std::clamp(fraction, 0.0, 1.0);
    const std::scoped_lock lock(m_shared->mutex);
    if (overall <= m_shared->reached)
        return;
    m_shared->reached = overall;
    m_shared->callback(overall);
}

Progress Progress::part(double from, double to) const
{
    Progress part = *this;
    part.m_from = m_from + (m_to - m_from) * from;
    part.m_to = m_from + (m_to - m_from) * to;
    return part;
}

CancelToken Progress::token() const
{
    return m_shared ? m_shared->token : CancelToken();
}

bool Progress::isCancelled() const
{
    return m_shared && m_shared->token.isCancelled();
}

} // namespace quadrille

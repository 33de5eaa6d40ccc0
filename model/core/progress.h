// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <memory>

namespace quadrille {

/// Asks a running job to stop; shared between the one who asks and the job. Safe from any thread.
class CancelToken
{
public:
    void cancel() noexcept { m_cancelled->store(true, std::memory_order_relaxed); }
    bool isCancelled() const noexcept { return m_cancelled->load(std::memory_order_relaxed); }

private:
    std::shared_ptr<std::atomic<bool>> m_cancelled = std::make_shared<std::atomic<bool>>(false);
};

/// How far a long computation is, and whether to go on. Parts nest: a callee reports 0 … 1 of its own work.
/// Cheap to copy. `report` may be called from any thread; so may the callback, one call at a time.
class Progress
{
public:
    /// Receives the overall fraction in [0, 1], never decreasing.
    using Callback = std::function<void(double)>;

    /// Neither reports nor cancels.
    Progress() = default;
    explicit Progress(CancelToken token, Callback callback = {});

    /// \param fraction of this part's work that is done, in [0, 1].
    /// \throws Error Cancelled once the token was cancelled.
    void report(double fraction) const;
    /// Reports done/total.
    void report(std::int64_t done, std::int64_t total) const
    {
        report(total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 1.0);
    }
    /// The part of the work between two fractions of this one.
    Progress part(double from, double to) const;
    bool isCancelled() const;
    /// The token that stops this work; one that nobody cancels where there is none.
    CancelToken token() const;

private:
    struct Shared;
    std::shared_ptr<Shared> m_shared;
    double m_from = 0;
    double m_to = 1;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/core/progress.h"

#include <mutex>
#include <string>

namespace quadrille::cli {

/// What the program says: results on standard output; warnings, errors and progress on standard error. Safe
/// from any thread.
class Console
{
public:
    enum class Level
    {
        Quiet,   ///< errors only
        Normal,  ///< results and warnings
        Verbose, ///< everything
    };

    Console();
    void setLevel(Level level) { m_level = level; }
    Level level() const { return m_level; }

    /// Something that was asked for by itself (`info`, `data`); also when quiet.
    void output(const std::string& text);
    /// What was done.
    void say(const std::string& text);
    /// What only verbose users want.
    void detail(const std::string& text);
    void warn(const std::string& text);
    void fail(const std::string& text);
    /// Warnings as warnings, the rest as details.
    void tell(const Issue& issue);

    /// A progress that is drawn as a bar on a terminal and not at all elsewhere.
    /// \param label what is going on, "Rebuilding".
    Progress progress(const CancelToken& token, const std::string& label);
    /// Takes the bar away.
    void endProgress();

private:
    void draw(double fraction);
    void clearBar();
    void redraw();

    Level m_level = Level::Normal;
    bool m_isTerminal = false;
    std::recursive_mutex m_mutex;
    std::string m_label;
    std::string m_bar; ///< as it stands on the terminal
};

} // namespace quadrille::cli

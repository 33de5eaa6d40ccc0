// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/cli/console.h"

#include <cstdio>
#include <unistd.h>

namespace quadrille::cli {

namespace {

void put(std::FILE* stream, const std::string& text)
{
    std::fwrite(text.data(), 1, text.size(), stream);
    std::fflush(stream);
}

} // namespace

Console::Console() : m_isTerminal(::isatty(STDERR_FILENO) == 1) {}

void Console::output(const std::string& text)
{
    const std::scoped_lock lock(m_mutex);
    clearBar();
    put(stdout, text + "\n");
    redraw();
}

void Console::say(const std::string& text)
{
    if (m_level != Level::Quiet)
        output(text);
}

void Console::detail(const std::string& text)
{
    if (m_level == Level::Verbose)
        output(text);
}

void Console::warn(const std::string& text)
{
    if (m_level == Level::Quiet)
        return;
    const std::scoped_lock lock(m_mutex);
    clearBar();
    put(stderr, std::string("warning: ").append(text).append("\n"));
    redraw();
}

void Console::fail(const std::string& text)
{
    const std::scoped_lock lock(m_mutex);
    clearBar();
    put(stderr, std::string("error: ").append(text).append("\n"));
    redraw();
}

void Console::tell(const Issue& issue)
{
    if (issue.severity == Issue::Severity::Warning)
        warn(issue.toString());
    else
        detail(issue.toString());
}

Progress Console::progress(const CancelToken& token, const std::string& label)
{
    if (!m_isTerminal || m_level == Level::Quiet)
        return Progress(token);
    {
        const std::scoped_lock lock(m_mutex);
        m_label = label;
    }
    draw(0);
    return Progress(token, [this](double fraction) { draw(fraction); });
}

void Console::endProgress()
{
    const std::scoped_lock lock(m_mutex);
    clearBar();
    m_bar.clear();
    m_label.clear();
}

void Console::draw(double fraction)
{
    const std::scoped_lock lock(m_mutex);
    constexpr int width = 32;
    const int done = static_cast<int>(fraction * width);
    std::string bar = m_label;
    bar += ' ';
    for (int i = 0; i < width; ++i)
        bar += i < done ? "█" : "░";
    bar.append(" ").append(std::to_string(static_cast<int>(fraction * 100))).append(" %");
    if (bar == m_bar)
        return;
    m_bar = std::move(bar);
    redraw();
}

void Console::clearBar()
{
    if (!m_bar.empty())
        put(stderr, "\r\x1b[K");
}

void Console::redraw()
{
    if (!m_bar.empty())
        put(stderr, std::string("\r").append(m_bar).append("\x1b[K"));
}

} // namespace quadrille::cli

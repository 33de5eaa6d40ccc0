// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/assimplog.h"

#include <assimp/DefaultLogger.hpp>
#include <assimp/LogStream.hpp>
#include <mutex>

namespace quadrille {

namespace {

thread_local std::vector<std::string>* listening = nullptr;

class Listener : public Assimp::LogStream
{
public:
    /// \param message  "Error, T0: what went wrong", with a line end.
    void write(const char* message) override
    {
        std::string_view text = message;
        if (const auto at = text.find(": "); at != std::string_view::npos)
            text.remove_prefix(at + 2);
        const bool isHarmless = text.find("no material assigned") != std::string_view::npos;
        if (listening && !isHarmless)
            listening->push_back(plainAssimpText(text));
    }
};

} // namespace

AssimpErrors::AssimpErrors()
{
    static std::once_flag once;
    std::call_once(once, [] {
        // The logger lives as long as the program and owns its stream.
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0)
            ->attachStream(new Listener, Assimp::Logger::Err);
    });
    listening = &m_lines;
}

AssimpErrors::~AssimpErrors()
{
    listening = nullptr;
}

std::string plainAssimpText(std::string_view text)
{
    constexpr std::size_t longest = 160;
    std::string line;
    for (const char c : text.substr(0, longest))
        line += c < ' ' || c > '~' ? ' ' : c;
    line.erase(line.find_last_not_of(" .") + 1);
    return text.size() > longest ? line + "…" : line;
}

} // namespace quadrille

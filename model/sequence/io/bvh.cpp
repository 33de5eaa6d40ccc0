// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/bvh.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/message.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace quadrille {

namespace {

constexpr std::size_t deepestJoint = 1000;

/// Words of a text with the line they stand in.
class Words
{
public:
    Words(std::string_view text, const std::filesystem::path& path) : m_text(text), m_path(path) {}

    bool isAtEnd()
    {
        while (m_at < m_text.size() && isSpace(m_text[m_at])) {
            m_line += m_text[m_at] == '\n';
            ++m_at;
        }
        return m_at == m_text.size();
    }
    /// The next word; empty at the end.
    std::string_view next()
    {
        if (isAtEnd())
            return {};
        const std::size_t start = m_at;
        while (m_at < m_text.size() && !isSpace(m_text[m_at]))
            ++m_at;
        return m_text.substr(start, m_at - start);
    }
    /// The rest of the line, which is a joint's name and may hold spaces.
    std::string restOfLine()
    {
        std::size_t end = m_text.find('\n', m_at);
        end = end == std::string_view::npos ? m_text.size() : end;
        std::string_view rest = m_text.substr(m_at, end - m_at);
        m_at = end;
        while (!rest.empty() && isSpace(rest.front()))
            rest.remove_prefix(1);
        if (const auto brace = rest.find('{'); brace != std::string_view::npos) {
            m_at -= rest.size() - brace;
            rest = rest.substr(0, brace);
        }
        while (!rest.empty() && isSpace(rest.back()))
            rest.remove_suffix(1);
        return std::string(rest);
    }
    void expect(std::string_view wanted)
    {
        const auto found = next();
        if (found != wanted)
            fail("“" + std::string(wanted) + "” expected, “" + shortened(found) + "” found");
    }
    double number()
    {
        auto word = next();
        if (word.starts_with('+'))
            word.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
            fail("a number expected, “" + shortened(word) + "” found");
        return value;
    }
    std::int64_t count()
    {
        const double value = number();
        if (value < 0 || value > 1e12 || value != std::floor(value))
            fail(QUADRILLE_MESSAGE("a count expected"));
        return static_cast<std::int64_t>(value);
    }
    std::size_t remaining() const { return m_text.size() - m_at; }
    std::int64_t line() const { return m_line; }
    [[noreturn]] void fail(const std::string& reason) const
    {
        throw Error(ErrorCode::FileSyntax, {m_path, {.line = m_line}, {{"reason", reason}}});
    }
    const std::filesystem::path& path() const { return m_path; }

private:
    static bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
    static std::string shortened(std::string_view word)
    {
        return word.empty() ? "the end" : std::string(word.substr(0, 40));
    }

    std::string_view m_text;
    const std::filesystem::path& m_path;
    std::size_t m_at = 0;
    std::int64_t m_line = 1;
};

std::optional<BvhChannel> channelOf(std::string_view word)
{
    static constexpr std::array<std::pair<std::string_view, BvhChannel>, 6> names = {
        {{"xposition", BvhChannel::XPosition},
         {"yposition", BvhChannel::YPosition},
         {"zposition", BvhChannel::ZPosition},
         {"xrotation", BvhChannel::XRotation},
         {"yrotation", BvhChannel::YRotation},
         {"zrotation", BvhChannel::ZRotation}}};
    std::string lower(word);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const auto& [name, channel] : names)
        if (lower == name)
            return channel;
    return std::nullopt;
}

Vec3d readOffset(Words& words)
{
    Vec3d offset;
    for (int axis = 0; axis < 3; ++axis)
        offset[axis] = words.number();
    return offset;
}

void readChannels(Words& words, Bvh& bvh, BvhJoint& joint)
{
    const std::int64_t count = words.count();
    if (count > 6)
        words.fail(QUADRILLE_MESSAGE("a joint has at most six channels"));
    joint.firstChannel = bvh.channelCount;
    for (std::int64_t c = 0; c < count; ++c) {
        const auto word = words.next();
        const auto channel = channelOf(word);
        if (!channel)
            words.fail("there is no channel “" + std::string(word.substr(0, 40)) + "”");
        joint.channels.push_back(*channel);
    }
    bvh.channelCount += joint.channels.size();
}

void readHierarchy(Words& words, Bvh& bvh)
{
    words.expect("HIERARCHY");
    words.expect("ROOT");
    std::vector<int> open; // joints whose brace is open; −1 stands for an end site
    const auto begin = [&](bool isEndSite) {
        std::string name = words.restOfLine();
        words.expect("{");
        if (open.size() >= deepestJoint)
            words.fail(QUADRILLE_MESSAGE("the joints are nested too deep"));
        if (isEndSite) {
            open.push_back(-1);
            return;
        }
        BvhJoint joint;
        joint.name = std::move(name);
        joint.parent = open.empty() ? -1 : open.back();
        open.push_back(static_cast<int>(bvh.joints.size()));
        bvh.joints.push_back(std::move(joint));
    };
    begin(false);
    while (!open.empty()) {
        const auto word = words.next();
        const int current = open.back();
        if (word == "}") {
            open.pop_back();
        } else if (word == "OFFSET") {
            const Vec3d offset = readOffset(words);
            if (current >= 0)
                bvh.joints[static_cast<std::size_t>(current)].offset = offset;
        } else if (word == "CHANNELS" && current >= 0) {
            readChannels(words, bvh, bvh.joints[static_cast<std::size_t>(current)]);
        } else if ((word == "JOINT" || word == "End") && current >= 0) {
            begin(word == "End");
        } else {
            words.fail(QUADRILLE_MESSAGE("OFFSET, CHANNELS, JOINT, End Site or } expected"));
        }
    }
}

/// The whole number of frames a second that a time of six decimals stands for, where there is one.
double roundedFps(double fps)
{
    constexpr double timeRounding = 0.5e-6; // seconds
    const double whole = std::round(fps);
    return std::abs(fps - whole) <= fps * fps * timeRounding ? whole : fps;
}

void readMotion(Words& words, Bvh& bvh)
{
    words.expect("MOTION");
    words.expect("Frames:");
    bvh.frameCount = words.count();
    words.expect("Frame");
    words.expect("Time:");
    const double seconds = words.number();
    if (!(seconds > 0))
        words.fail(QUADRILLE_MESSAGE("the frame time is not above zero"));
    bvh.fps = roundedFps(1.0 / seconds);
    if (bvh.channelCount == 0 || bvh.frameCount == 0)
        words.fail(QUADRILLE_MESSAGE("there is no motion"));
    // Each number takes two characters at least.
    if (static_cast<std::uint64_t>(bvh.frameCount) > (words.remaining() / 2 + 1) / bvh.channelCount) {
        throw Error(ErrorCode::CountTooLarge,
                    {words.path(),
                     {.line = words.line()},
                     {{"count", std::to_string(bvh.frameCount)}, {"what", "frames"}}});
    }
    bvh.motion.reserve(static_cast<std::size_t>(bvh.frameCount) * bvh.channelCount);
    for (std::int64_t f = 0; f < bvh.frameCount; ++f) {
        for (std::size_t c = 0; c < bvh.channelCount; ++c) {
            if (words.isAtEnd()) {
                throw Error(ErrorCode::FileTruncated,
                            {words.path(),
                             {.line = words.line()},
                             {{"expected", std::to_string(bvh.frameCount) + " frames"},
                              {"found", std::to_string(f)}}});
            }
            bvh.motion.push_back(words.number());
        }
    }
}

} // namespace

Bvh readBvh(const std::filesystem::path& path)
{
    const FileContent file = readFile(path);
    return parseBvh(file.text(), path);
}

Bvh parseBvh(std::string_view text, const std::filesystem::path& path)
{
    if (text.find('\0') != std::string_view::npos)
        throw Error(ErrorCode::FileEncoding, {path, {}, {}});
    if (text.starts_with("\xef\xbb\xbf"))
        text.remove_prefix(3);
    Words words(text, path);
    Bvh bvh;
    readHierarchy(words, bvh);
    readMotion(words, bvh);
    return bvh;
}

} // namespace quadrille

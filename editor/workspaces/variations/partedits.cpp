// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partedits.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace quadrille {

namespace {

template <typename Body>
auto* curveIn(Body& body, const std::string& name)
{
    const auto found = std::find_if(body.curves.begin(), body.curves.end(),
                                    [&](const PartCurveEntry& entry) { return entry.curve.name == name; });
    return found == body.curves.end() ? nullptr : &*found;
}

template <typename Body>
auto* partIn(Body& body, const std::string& name)
{
    const auto found = std::find_if(body.parts.begin(), body.parts.end(),
                                    [&](const PartEntry& entry) { return entry.part.name == name; });
    return found == body.parts.end() ? nullptr : &*found;
}

template <typename IsTaken>
std::string freeName(const std::string& wanted, const IsTaken& isTaken)
{
    std::string name = wanted;
    for (int number = 2; isTaken(name); ++number)
        name = wanted + ' ' + std::to_string(number);
    return name;
}

bool isLetter(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Exchanges the first whole word `from`; empty where there is none.
std::string withWord(const std::string& name, const std::string& from, const std::string& to)
{
    for (std::size_t at = name.find(from); at != std::string::npos; at = name.find(from, at + 1)) {
        const std::size_t end = at + from.size();
        const bool startsWord = at == 0 || !isLetter(name[at - 1]);
        const bool endsWord = end == name.size() || !isLetter(name[end]);
        if (startsWord && endsWord)
            return name.substr(0, at) + to + name.substr(end);
    }
    return {};
}

} // namespace

PartCurveEntry* findCurve(BodyPartsEntry& body, const std::string& name)
{
    return curveIn(body, name);
}

const PartCurveEntry* findCurve(const BodyPartsEntry& body, const std::string& name)
{
    return curveIn(body, name);
}

PartEntry* findPart(BodyPartsEntry& body, const std::string& name)
{
    return partIn(body, name);
}

const PartEntry* findPart(const BodyPartsEntry& body, const std::string& name)
{
    return partIn(body, name);
}

const PartEntry* rootOf(const BodyPartsEntry& body)
{
    const auto found = std::find_if(body.parts.begin(), body.parts.end(),
                                    [](const PartEntry& entry) { return entry.part.parent.empty(); });
    return found == body.parts.end() ? nullptr : &*found;
}

std::vector<PartCurve> curvesOf(const BodyPartsEntry& body)
{
    std::vector<PartCurve> curves;
    curves.reserve(body.curves.size());
    for (const PartCurveEntry& entry : body.curves)
        curves.push_back(entry.curve);
    return curves;
}

std::vector<PartDescription> partsOf(const BodyPartsEntry& body)
{
    std::vector<PartDescription> parts;
    parts.reserve(body.parts.size());
    for (const PartEntry& entry : body.parts)
        parts.push_back(entry.part);
    return parts;
}

std::string freeCurveName(const BodyPartsEntry& body, const std::string& wanted)
{
    return freeName(wanted, [&](const std::string& name) { return findCurve(body, name) != nullptr; });
}

std::string freePartName(const BodyPartsEntry& body, const std::string& wanted)
{
    return freeName(wanted, [&](const std::string& name) { return findPart(body, name) != nullptr; });
}

std::vector<std::string> partsWith(const BodyPartsEntry& body, const std::string& curve)
{
    std::vector<std::string> names;
    for (const PartEntry& entry : body.parts)
        if (const auto& curves = entry.part.curves;
            std::find(curves.begin(), curves.end(), curve) != curves.end())
            names.push_back(entry.part.name);
    return names;
}

void renameCurve(BodyPartsEntry& body, const std::string& before, const std::string& after)
{
    if (PartCurveEntry* entry = findCurve(body, before))
        entry->curve.name = after;
    for (PartEntry& entry : body.parts)
        std::replace(entry.part.curves.begin(), entry.part.curves.end(), before, after);
}

void removeCurve(BodyPartsEntry& body, const std::string& name)
{
    std::erase_if(body.curves, [&](const PartCurveEntry& entry) { return entry.curve.name == name; });
}

void renamePart(BodyPartsEntry& body, const std::string& before, const std::string& after)
{
    for (PartEntry& entry : body.parts) {
        if (entry.part.name == before)
            entry.part.name = after;
        if (entry.part.parent == before)
            entry.part.parent = after;
    }
}

void removePart(BodyPartsEntry& body, const std::string& name)
{
    const PartEntry* gone = findPart(body, name);
    if (gone == nullptr)
        return;
    const std::string parent = gone->part.parent;
    if (parent.empty()) {
        body.parts.clear();
        return;
    }
    std::erase_if(body.parts, [&](const PartEntry& entry) { return entry.part.name == name; });
    for (PartEntry& entry : body.parts)
        if (entry.part.parent == name)
            entry.part.parent = parent;
}

void addPart(BodyPartsEntry& body, const std::string& name, const std::string& root,
             const std::string& parent, const std::vector<std::string>& curves)
{
    if (rootOf(body) == nullptr)
        body.parts.insert(body.parts.begin(),
                          PartEntry{.part = {.name = root, .parent = {}, .curves = {}}, .unknown = {}});
    const std::string& hangsOn = parent.empty() ? rootOf(body)->part.name : parent;
    body.parts.push_back({.part = {.name = name, .parent = hangsOn, .curves = curves}, .unknown = {}});
}

std::string otherSideName(const std::string& name)
{
    static const std::array<std::pair<const char*, const char*>, 5> words{
        {{"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}, {"l", "r"}, {"L", "R"}}};
    for (const auto& [left, right] : words) {
        if (std::string other = withWord(name, left, right); !other.empty())
            return other;
        if (std::string other = withWord(name, right, left); !other.empty())
            return other;
    }
    return {};
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/labelcolors.h"

#include "editor/documents/projectdocument.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>

namespace quadrille {

namespace {

/// From Okabe and Ito and from Tableau, without those near the colours of the feet; the first ones first.
constexpr std::size_t usual = 8;
constexpr std::array<QRgb, 16> labelColors = {0xE69F00, 0x56B4E9, 0x009E73, 0xF0E442, 0xD55E00, 0x9C755F,
                                              0x76B7B2, 0xBAB0AC, 0x8CD17D, 0xB6992D, 0x2F7F86, 0x79706E,
                                              0xA0CBE8, 0xFF9D76, 0x6B8E23, 0x7F63B8};
constexpr QRgb leftFoot = 0xCC79A7;
constexpr QRgb rightFoot = 0x0072B2;

/// The same on every computer and in every run (FNV-1a), other than qHash.
std::size_t placeOf(const QString& label)
{
    std::uint32_t hash = 2166136261U;
    for (const char byte : label.toUtf8()) {
        hash ^= static_cast<unsigned char>(byte);
        hash *= 16777619U;
    }
    return hash % usual;
}

} // namespace

LabelColors& LabelColors::of(ProjectDocument& document)
{
    auto* colors = document.findChild<LabelColors*>(QString(), Qt::FindDirectChildrenOnly);
    return colors != nullptr ? *colors : *new LabelColors(document);
}

LabelColors::LabelColors(ProjectDocument& document) : QObject(&document), m_document(document)
{
    connect(&document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.kind == ChangeEvent::Kind::Reset)
            reset();
    });
    reset();
}

void LabelColors::reset()
{
    m_places.clear();
    std::set<std::string> labels;
    for (const SequenceEntry& sequence : m_document.project().sequences) {
        for (const LabelSpan& span : sequence.labels)
            labels.insert(span.label);
    }
    for (const std::string& label : labels)
        color(label);
    emit changed();
}

QColor LabelColors::color(const QString& label)
{
    auto place = m_places.constFind(label);
    if (place == m_places.cend()) {
        std::array<int, labelColors.size()> uses{};
        for (const int taken : std::as_const(m_places))
            ++uses.at(static_cast<std::size_t>(taken));
        const int fewest = *std::ranges::min_element(uses);
        const std::size_t ring =
            std::ranges::count(std::span(uses).first(usual), fewest) > 0 ? usual : labelColors.size();
        std::size_t free = placeOf(label);
        while (uses.at(free) > fewest)
            free = (free + 1) % ring;
        place = m_places.insert(label, static_cast<int>(free));
    }
    return QColor::fromRgb(labelColors.at(static_cast<std::size_t>(*place)));
}

QColor LabelColors::contact(const std::string& foot)
{
    return QColor::fromRgb(foot == "right" ? rightFoot : leftFoot);
}

} // namespace quadrille

#include "moc_labelcolors.cpp"

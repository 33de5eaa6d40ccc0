// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/selection.h"

#include <algorithm>

namespace quadrille {

Selection::Selection(ProjectDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    connect(&document, &ProjectDocument::renamed, this, &Selection::rename);
    connect(&document, &ProjectDocument::changed, this, &Selection::follow);
}

void Selection::select(const EntryRef& entry)
{
    if (entry.section == Section::Sequences && !entry.name.isEmpty()) {
        selectSequences({entry.name});
        return;
    }
    if (entry.section == Section::Animations && !entry.name.isEmpty()) {
        selectAnimations({entry.name});
        return;
    }
    if (m_current == entry && m_sequences.isEmpty())
        return;
    m_current = entry;
    m_sequences.clear();
    if (entry.section == Section::Variations && !entry.name.isEmpty())
        m_shownVariation = entry.name;
    if (entry.section == Section::Appearances && !entry.name.isEmpty())
        m_shownAppearance = entry.name;
    if (entry.section == Section::Transfers && !entry.name.isEmpty())
        m_shownTransfer = entry.name;
    emit changed();
}

void Selection::selectSequences(const QStringList& names, const QString& current)
{
    if (names.isEmpty()) {
        clear();
        return;
    }
    const EntryRef entry{Section::Sequences, names.contains(current) ? current : names.back()};
    if (m_current == entry && m_sequences == names)
        return;
    m_current = entry;
    m_sequences = names;
    m_shown = entry.name;
    emit changed();
}

void Selection::selectAnimations(const QStringList& names)
{
    const EntryRef entry{Section::Animations, names.value(names.size() - 1)};
    if (entry.name.isEmpty() || (m_current == entry && m_animations == names))
        return;
    m_current = entry;
    m_sequences.clear();
    m_animations = names;
    m_shownAnimation = entry.name;
    emit changed();
}

bool Selection::exists(const EntryRef& entry) const
{
    if (entry.name.isEmpty())
        return true;
    // Of graphs and body parts a character has some, whether the project says any or not.
    if (entry.section == Section::Graphs || entry.section == Section::BodyParts)
        return true;
    return findSection(entry.section)->names(m_document.project()).contains(entry.name);
}

void Selection::showExisting()
{
    const auto first = [](const auto& entries) {
        return entries.empty() ? QString() : QString::fromStdString(entries.front().name);
    };
    if (m_document.sequence(m_shown) == nullptr)
        m_shown = first(m_document.project().sequences);
    if (m_document.variation(m_shownVariation) == nullptr)
        m_shownVariation = first(m_document.project().variations);
    if (findAppearance(m_document.project(), m_shownAppearance.toStdString()) == nullptr)
        m_shownAppearance = first(m_document.project().appearances);
    if (findTransfer(m_document.project(), m_shownTransfer.toStdString()) == nullptr)
        m_shownTransfer = first(m_document.project().transfers);
    m_animations.removeIf([this](const QString& name) { return m_document.animation(name) == nullptr; });
    if (m_document.animation(m_shownAnimation) == nullptr)
        m_shownAnimation =
            m_animations.isEmpty() ? first(m_document.project().animations) : m_animations.back();
    if (m_animations.isEmpty() && !m_shownAnimation.isEmpty())
        m_animations = {m_shownAnimation};
}

void Selection::rename(const ChangeEvent& event)
{
    if (m_current == EntryRef{event.entry.section, event.before})
        m_current.name = event.entry.name;
    if (event.entry.section == Section::Sequences) {
        std::ranges::replace(m_sequences, event.before, event.entry.name);
        if (m_shown == event.before)
            m_shown = event.entry.name;
    }
    if (event.entry.section == Section::Animations) {
        std::ranges::replace(m_animations, event.before, event.entry.name);
        if (m_shownAnimation == event.before)
            m_shownAnimation = event.entry.name;
    }
    if (event.entry.section == Section::Variations && m_shownVariation == event.before)
        m_shownVariation = event.entry.name;
    if (event.entry.section == Section::Appearances && m_shownAppearance == event.before)
        m_shownAppearance = event.entry.name;
    if (event.entry.section == Section::Transfers && m_shownTransfer == event.before)
        m_shownTransfer = event.entry.name;
}

void Selection::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Renamed) {
        emit changed();
    } else if (event.kind == ChangeEvent::Kind::List || event.kind == ChangeEvent::Kind::Reset) {
        const QString shownBefore = m_shown;
        const QString animationBefore = m_shownAnimation;
        const QString variationBefore = m_shownVariation;
        const QString appearanceBefore = m_shownAppearance;
        const QString transferBefore = m_shownTransfer;
        const auto animationsBefore = m_animations.size();
        const auto countBefore = m_sequences.size();
        m_sequences.removeIf([this](const QString& name) { return m_document.sequence(name) == nullptr; });
        showExisting();
        const bool currentIsThere = exists(m_current);
        if (!currentIsThere)
            m_current = m_sequences.isEmpty() ? EntryRef{} : EntryRef{Section::Sequences, m_sequences.back()};
        if (!currentIsThere || m_shown != shownBefore || m_sequences.size() != countBefore ||
            m_shownAnimation != animationBefore || m_shownVariation != variationBefore ||
            m_shownAppearance != appearanceBefore || m_shownTransfer != transferBefore ||
            m_animations.size() != animationsBefore)
            emit changed();
    }
}

} // namespace quadrille

#include "moc_selection.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What frames are drawn from that an animation shows again.
#include "editor/context/editorcontext.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/postpanel.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/results/openanimation.h"

#include <QComboBox>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <algorithm>

namespace quadrille {

namespace {

/// The items before those of single variations.
enum Item
{
    AsCaptured,
    FromAny,
    FirstName,
};

VariedRepeats repeatsOf(const AnimationEntry& entry)
{
    return entry.post.variations.value_or(VariedRepeats());
}

} // namespace

void PostPanel::addRepeats()
{
    m_form->addHeading([] { return tr("Variations"); });
    m_repeated = new QComboBox;
    m_repeated->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_repeated->setFocusPolicy(Qt::StrongFocus);
    const auto set = [this](int index) {
        change(tr("Frames shown again"), "postVariations", [&](AnimationEntry& entry) {
            if (index == AsCaptured) {
                entry.post.variations.reset();
                return;
            }
            VariedRepeats repeats = repeatsOf(entry);
            repeats.from = m_repeated->itemData(index).toString().toStdString();
            entry.post.variations = repeats;
        });
    };
    connect(m_repeated, &QComboBox::currentIndexChanged, this, set);
    m_fields.addOther(
        {"postVariations", [] { return tr("Frames shown again"); },
         [] {
             return tr("The first time captured frames are shown as they are; each further time they "
                       "can be drawn from another variation of their take, so that repeats are never "
                       "the same");
         }},
        m_repeated, [this](const AnimationEntry& entry) { refreshRepeats(entry); },
        [](const AnimationEntry& entry) { return !entry.post.variations; }, [set] { set(AsCaptured); });
    m_fields.addNumber(
        {"postVariationEase", [] { return tr("Ease"); },
         [] { return tr("How long poses take from captured frames to varied ones, and back"); },
         [](const AnimationEntry& entry) { return entry.post.variations.has_value(); }},
        lensInside<AnimationEntry>(at(&AnimationEntry::post, &PostProcessingEntry::variations),
                                   &VariedRepeats::ease),
        {.path = "varied_repeats.ease",
         .step = 0.05,
         .unit = [] { return tr(" s", "unit of a number"); },
         .highest = 5});
}

void PostPanel::refreshRepeats(const AnimationEntry& entry)
{
    const QSignalBlocker blocker(m_repeated);
    m_repeated->clear();
    m_repeated->addItem(tr("As captured"));
    m_repeated->addItem(tr("From all"), QString());
    const Project& project = m_animation.context().document.project();
    for (const VariationEntry* variation : learnedVariations(project, characterNameOf(project, entry))) {
        const QString name = QString::fromStdString(variation->name);
        m_repeated->addItem(tr("From “%1”", "variations").arg(name), name);
    }
    if (!entry.post.variations)
        return;
    const QString from = QString::fromStdString(entry.post.variations->from);
    const int found = from.isEmpty() ? FromAny : m_repeated->findData(from);
    if (found < 0)
        m_repeated->addItem(tr("From “%1”", "variations").arg(from), from);
    m_repeated->setCurrentIndex(found < 0 ? m_repeated->count() - 1 : found);
}

QString PostPanel::problemOfRepeats(const AnimationEntry& entry) const
{
    if (!entry.post.variations)
        return {};
    if (m_repeated->count() == FirstName)
        return tr("There are no variations to draw from: learn some in the workspace Variations.");
    const auto result = m_animation.result();
    if (result == nullptr || !result->isFinal || result->entry.post.variations != entry.post.variations)
        return {};
    const auto isRepeat = [](const SpanDraw& span) { return span.isRepeat; };
    if (std::ranges::none_of(result->spans, isRepeat))
        return tr("This animation shows no frames again.");
    const auto isAsCaptured = [](const SpanDraw& span) { return span.isRepeat && !span.variation; };
    if (std::ranges::any_of(result->spans, isAsCaptured))
        return tr("Some frames are shown again as captured: no variation varies them.");
    return {};
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The sections that say how a clip is sought and blended.
#include "editor/workspaces/animate/postpanel.h"

namespace quadrille {

namespace {

using Entry = AnimationEntry;

/// A switch between “As published” and what is usual, in this order.
template <typename Member>
Lens<Entry, int> notPublished(Member isPublished)
{
    return {[=](const Entry& entry) { return memberOf(entry, isPublished) ? 0 : 1; },
            [=](Entry& entry, int index) { memberOf(entry, isPublished) = index == 0; }};
}

double usual(const char* path)
{
    return factsOf(path).usual.value_or(0);
}

} // namespace

void PostPanel::addBlending()
{
    m_form->addHeading([] { return tr("Blending"); });
    m_fields.addChoice(
        {"postBlend", [] { return tr("Transitions"); },
         [] { return tr("Gentle keeps the speed of both takes smooth and standing feet in place"); }},
        &Entry::gentleBlend, {[] { return tr("As published"); }, [] { return tr("Gentle"); }});
    m_fields.addChoice(
        {"postInterpolation", [] { return tr("Between poses"); },
         [] {
             return tr(
                 "How a pose between two poses comes about: turning and stretching every triangle (Poisson), "
                 "turning it and stretching linearly (Slerp), or on straight lines (Linear)");
         }},
        &Entry::interpolation,
        {[] { return tr("Poisson"); }, [] { return tr("Slerp"); }, [] { return tr("Linear"); }});
}

void PostPanel::addSearch()
{
    const auto of = [](auto member) { return at(&Entry::search, member); };
    m_form->addHeading([] { return tr("Search"); });
    m_fields.addChoice({"searchStyle", [] { return tr("Walks"); },
                        [] {
                            return tr("Calm walks stay in a take for a while, need not keep to a path by the "
                                      "centimetre, and prefer takes of locomotion along it");
                        }},
                       notPublished(of(&SearchEntry::isPaper)),
                       {[] { return tr("As published"); }, [] { return tr("Calm"); }});
    m_fields.addNumber(
        {"searchDwell", [] { return tr("Stay in a take"); },
         [] { return tr("Least time between two transitions of a calm walk"); }},
        of(&SearchEntry::dwell),
        {.path = "search.dwell",
         .unit = [] { return tr(" s"); },
         .automatic = [] { return tr("usual (%L1 s)", "seconds").arg(usual("search.dwell")); }});
    m_fields.addNumber(
        {"searchDeadZone", [] { return tr("Off the path"); },
         [] { return tr("How far from a path a calm walk may be without any cost"); }},
        of(&SearchEntry::deadZone),
        {.path = "search.dead_zone",
         .step = 0.01,
         .unit = [] { return tr(" m"); },
         .automatic = [] { return tr("usual (%L1 m)", "metres").arg(usual("search.dead_zone")); }});
    m_fields.addNumber(
        {"searchSteering", [] { return tr("Steering"); },
         [] {
             return tr("How far a calm walk turns towards its path at most, beyond what was captured; "
                       "0: not at all");
         }},
        of(&SearchEntry::steering),
        {.path = "search.steering",
         .step = 5,
         .decimals = 1,
         .unit = [] { return tr("°/m"); },
         .automatic = [] { return tr("usual (%L1°/m)", "degrees a metre").arg(usual("search.steering")); }});
    m_fields.addNumber(
        {"searchBudget", [] { return tr("Budget"); },
         [] {
             return tr("States that are looked at: more finds better walks and takes longer; the same "
                       "budget finds the same walk on every machine");
         }},
        of(&SearchEntry::budget),
        {.path = "search.budget",
         .step = 1000,
         .decimals = 0,
         .automatic =
             [] {
                 const auto states = static_cast<qlonglong>(usual("search.budget"));
                 return tr("usual (%L1)", "a number of states").arg(states);
             },
         .lowest = 1000});
    m_fields.addNumber(
        {"searchBeta", [] { return tr("Timing, β"); },
         [] {
             return tr("What a frame of timing error costs: more meets times better, with worse transitions");
         }},
        of(&SearchEntry::beta),
        {.path = "search.beta", .step = 0.01, .decimals = 3, .automatic = [] { return tr("10 α"); }});
    m_fields.addNumber(
        {"searchMu", [] { return tr("Transitions, μ"); },
         [] { return tr("What transitions count against squared metres of deviation from a path"); }},
        of(&SearchEntry::mu), {.path = "search.mu", .step = 0.05, .decimals = 3, .automatic = [] {
                                   return tr("usual (%L1)", "a weight").arg(usual("search.mu"));
                               }});
    m_fields.addSwitch(
        {"searchGlobal", [] { return tr("All keys at once"); },
         [] { return tr("Seeks the best walk over all keys; otherwise from key to key, as published"); }},
        of(&SearchEntry::globalKeys));
}

} // namespace quadrille

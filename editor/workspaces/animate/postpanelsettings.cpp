// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The sections that say how a clip is sought and blended.
#include "editor/fields/settingform.h"
#include "editor/workspaces/animate/postpanel.h"
#include "model/project/walkrequest.h"
#include "model/synthesis/searchsettings.h"

namespace quadrille {

void PostPanel::addBlending()
{
    m_form->addHeading([] { return tr("Blending"); });
    addChoice({"postBlend", [] { return tr("Transitions"); },
               [] { return tr("Gentle keeps the speed of both takes smooth and standing feet in place"); },
               [](const AnimationEntry& entry) { return entry.gentleBlend ? 1 : 0; },
               [](AnimationEntry& entry, int index) { entry.gentleBlend = index == 1; }},
              {[] { return tr("As published"); }, [] { return tr("Gentle"); }});
    addChoice(
        {"postInterpolation", [] { return tr("Between poses"); },
         [] {
             return tr(
                 "How a pose between two poses comes about: turning and stretching every triangle (Poisson), "
                 "turning it and stretching linearly (Slerp), or on straight lines (Linear)");
         },
         [](const AnimationEntry& entry) { return static_cast<int>(entry.interpolation); },
         [](AnimationEntry& entry, int index) {
             entry.interpolation = static_cast<InterpolationMethod>(index);
         }},
        {[] { return tr("Poisson"); }, [] { return tr("Slerp"); }, [] { return tr("Linear"); }});
}

void PostPanel::addSearch()
{
    const SearchSettings usual = SearchSettings::calm();
    m_form->addHeading([] { return tr("Search"); });
    addChoice({"searchStyle", [] { return tr("Walks"); },
               [] {
                   return tr("Calm walks stay in a take for a while, need not keep to a path by the "
                             "centimetre, and prefer takes of locomotion along it");
               },
               [](const AnimationEntry& entry) { return entry.search.isPaper ? 0 : 1; },
               [](AnimationEntry& entry, int index) { entry.search.isPaper = index == 0; }},
              {[] { return tr("As published"); }, [] { return tr("Calm"); }});
    addNumber({"searchDwell", [] { return tr("Stay in a take"); },
               [] { return tr("Least time between two transitions of a calm walk"); },
               [](const AnimationEntry& entry) { return entry.search.dwell; },
               [](AnimationEntry& entry, std::optional<double> value) { entry.search.dwell = value; }},
              {.highest = 60,
               .step = 0.1,
               .decimals = 2,
               .unit = [] { return tr(" s"); },
               .automatic = [] { return tr("usual (%L1 s)", "seconds").arg(usualDwell); }});
    addNumber(
        {"searchDeadZone", [] { return tr("Off the path"); },
         [] { return tr("How far from a path a calm walk may be without any cost"); },
         [](const AnimationEntry& entry) { return entry.search.deadZone; },
         [](AnimationEntry& entry, std::optional<double> value) { entry.search.deadZone = value; }},
        {.highest = 100,
         .step = 0.01,
         .decimals = 2,
         .unit = [] { return tr(" m"); },
         .automatic = [zone = usual.charging.deadZone] { return tr("usual (%L1 m)", "metres").arg(zone); }});
    addNumber({"searchSteering", [] { return tr("Steering"); },
               [] {
                   return tr("How far a calm walk turns towards its path at most, beyond what was captured; "
                             "0: not at all");
               },
               [](const AnimationEntry& entry) { return entry.search.steering; },
               [](AnimationEntry& entry, std::optional<double> value) { entry.search.steering = value; }},
              {.highest = 360,
               .step = 5,
               .decimals = 1,
               .unit = [] { return tr("°/m"); },
               .automatic = [] { return tr("usual (%L1°/m)", "degrees a metre").arg(usualSteering); }});
    addNumber(
        {"searchBudget", [] { return tr("Budget"); },
         [] {
             return tr("States that are looked at: more finds better walks and takes longer; the same "
                       "budget finds the same walk on every machine");
         },
         [](const AnimationEntry& entry) {
             return entry.search.budget ? std::optional(static_cast<double>(*entry.search.budget))
                                        : std::nullopt;
         },
         [](AnimationEntry& entry, std::optional<double> value) {
             entry.search.budget = value ? std::optional(static_cast<std::int64_t>(*value)) : std::nullopt;
         }},
        {.lowest = 1000, .highest = 1e9, .step = 1000, .decimals = 0, .automatic = [budget = usual.budget] {
             return tr("usual (%L1)", "a number of states").arg(budget);
         }});
    addNumber({"searchBeta", [] { return tr("Timing, β"); },
               [] {
                   return tr("What a frame of timing error costs: more meets times better, with worse "
                             "transitions");
               },
               [](const AnimationEntry& entry) { return entry.search.beta; },
               [](AnimationEntry& entry, std::optional<double> value) { entry.search.beta = value; }},
              {.highest = 1000, .step = 0.01, .decimals = 3, .automatic = [] { return tr("10 α"); }});
    addNumber({"searchMu", [] { return tr("Transitions, μ"); },
               [] { return tr("What transitions count against squared metres of deviation from a path"); },
               [](const AnimationEntry& entry) { return entry.search.mu; },
               [](AnimationEntry& entry, std::optional<double> value) { entry.search.mu = value; }},
              {.highest = 1000, .step = 0.05, .decimals = 3, .automatic = [mu = usual.mu] {
                   return tr("usual (%L1)", "a weight").arg(mu);
               }});
    addSwitch(
        {"searchGlobal", [] { return tr("&All keys at once"); },
         [] { return tr("Seeks the best walk over all keys; otherwise from key to key, as published"); },
         [](const AnimationEntry& entry) { return entry.search.globalKeys; },
         [](AnimationEntry& entry, bool on) { entry.search.globalKeys = on; }});
}

} // namespace quadrille

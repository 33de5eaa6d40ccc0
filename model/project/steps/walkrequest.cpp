// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/walkrequest.h"

#include "model/core/message.h"
#include "model/project/document/findentry.h"
#include "model/project/document/groundpoint.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/fields/writefields.h"
#include "model/project/steps/animate.h"
#include "model/project/steps/pathrequest.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

namespace quadrille {

namespace {

/// Turns the constraints of one animation into frames, one by one.
class Request
{
public:
    Request(const AnimationEntry& animation, const CharacterGraph& graph)
        : m_animation(animation), m_graph(graph), m_project(graph.work().opener->project())
    {
    }

    WalkConstraints constraints()
    {
        if (m_animation.start)
            m_constraints.start = frames(*m_animation.start);
        for (const ConstraintEntry& constraint : m_animation.constraints)
            std::visit([this](const auto& entry) { add(entry); }, constraint);
        const JunctionsEntry& junctions = m_animation.junctions;
        m_constraints.junctions.banned = pairs(junctions.banned);
        m_constraints.junctions.required = pairs(junctions.locked);
        for (const FramePair& chosen : pairs(junctions.chosen))
            m_constraints.junctions.required.push_back(chosen);
        m_constraints.junctions.walk = walkOf(junctions.walk, m_graph);
        return std::move(m_constraints);
    }

private:
    double frameCount(double seconds) const { return seconds * m_project.settings.fps; }
    std::optional<double> frameCount(std::optional<double> seconds) const
    {
        return seconds ? std::optional(frameCount(*seconds)) : std::nullopt;
    }

    FrameSet frames(const FrameChoice& choice) const
    {
        if (choice.label.empty())
            return {choice.sequence, {m_graph.span(choice.sequence, choice.range)}};
        FrameSet set{choice.label, {}};
        for (const std::string& name : m_graph.work().sequences) {
            for (const LabelSpan& span : findSequence(m_project, name)->labels) {
                if (span.label == choice.label)
                    set.spans.push_back(m_graph.span(name, span.frames));
            }
        }
        if (set.spans.empty())
            throwInvalid("No sequence has the label “" + choice.label + "”",
                         QUADRILLE_MESSAGE("Give some frames of a sequence this label."));
        return set;
    }

    std::vector<FramePair> pairs(const std::vector<JunctionEntry>& junctions) const
    {
        std::vector<FramePair> all;
        all.reserve(junctions.size());
        for (const JunctionEntry& junction : junctions)
            all.push_back({m_graph.node(junction.from), m_graph.node(junction.to)});
        return all;
    }

    void add(const KeyEntry& key)
    {
        m_constraints.keys.push_back({.frame = m_graph.node({key.sequence, key.frame}),
                                      .time = frameCount(key.time),
                                      .tolerance = frameCount(key.tolerance)});
    }

    void add(const PathEntry& path)
    {
        const double metres = m_graph.metresPerUnit();
        PathConstraint constraint = pathInMetres(path, m_project.settings.axes);
        for (const PathSpanEntry& span : path.spans) {
            PathSpan& own = constraint.spans.emplace_back();
            own.from = span.from * metres;
            own.to = span.to * metres;
            if (span.frames)
                own.demanded = frames(*span.frames);
            own.duration = frameCount(span.duration);
        }
        m_constraints.path = std::move(constraint);
    }

    void add(const ActionEntry& action)
    {
        const Action usual;
        m_constraints.actions.push_back({.frames = frames(action.frames),
                                         .repetitions = action.repeat,
                                         .duration = frameCount(action.duration),
                                         .leastShare = action.leastShare.value_or(usual.leastShare)});
    }

    const AnimationEntry& m_animation;
    const CharacterGraph& m_graph;
    const Project& m_project;
    WalkConstraints m_constraints;
};

} // namespace

WalkConstraints walkConstraints(const AnimationEntry& animation, const CharacterGraph& graph)
{
    return Request(animation, graph).constraints();
}

std::optional<PathConstraint> pathOf(const AnimationEntry& animation, const CharacterGraph& graph)
{
    for (const ConstraintEntry& constraint : animation.constraints)
        if (const auto* path = std::get_if<PathEntry>(&constraint))
            return curveInMetres(*path, graph.metresPerUnit());
    return std::nullopt;
}

CostWeights costWeights(const AnimationEntry& animation, const CharacterGraph& graph)
{
    const SearchSettings settings = searchSettings(animation.search, graph.fps());
    const bool hasPath = std::ranges::any_of(animation.constraints, [](const ConstraintEntry& constraint) {
        return std::holds_alternative<PathEntry>(constraint);
    });
    return {.mu = hasPath ? settings.mu : 1, .beta = settings.beta.value_or(betaPerAlpha * graph.alpha())};
}

Walk walkOf(const std::vector<WalkSpanEntry>& spans, const CharacterGraph& graph)
{
    Walk walk;
    for (const WalkSpanEntry& span : spans)
        walk.spans.push_back(graph.span(span.sequence, span.frames));
    return walk;
}

GroundMotion startOf(const WalkEntry& entry, const CharacterGraph& graph)
{
    const Project& project = graph.work().opener->project();
    const Ground ground(project.settings.axes.up);
    const NodeIndex first = graph.node({entry.spans.front().sequence, entry.spans.front().frames.first});
    const Vec2d centre = ground.of(graph.roots().centres[static_cast<std::size_t>(first)]);
    const Vec2d at = entry.at ? ground.of(pointOnGround(*entry.at, project.settings.axes.up)) : centre;
    return GroundMotion::taking(centre, at, entry.turn * std::numbers::pi / 180);
}

std::string walkSettings(const AnimationEntry& animation, const CharacterInputs& work)
{
    AnimationEntry asked = animation;
    asked.name.clear();
    asked.interpolation = {};
    asked.post = {};
    const Project& project = work.opener->project();
    nlohmann::json json;
    json["animation"] = animationSettings(asked, project.settings.axes.up);
    json["alpha"] = work.graph.alpha;
    if (hasLoopEnds(animation))
        json["loops"] = true;
    for (const std::string& name : work.sequences) {
        nlohmann::json labels = nlohmann::json::array();
        for (const LabelSpan& span : findSequence(project, name)->labels)
            labels.push_back({span.label, span.frames.first.value, span.frames.last.value});
        json["sequences"].push_back({name, labels});
    }
    return json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validateanimations.h"

#include "model/core/contains.h"
#include "model/project/document/clipdependencies.h"
#include "model/project/document/findentry.h"
#include "model/project/document/groundpoint.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/problemtexts.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr double greatestFactor = 1000; ///< of a retiming

/// Checks one animation.
class AnimationValidator
{
public:
    AnimationValidator(const Project& project, const AnimationEntry& animation, std::string pointer,
                       ProjectProblems& problems)
        : m_project(project)
        , m_animation(animation)
        , m_pointer(std::move(pointer))
        , m_problems(problems)
        , m_sequences(sequencesOfGraph(project, characterNameOf(project, animation)))
    {
    }

    void run()
    {
        const auto known = namesOf(m_project.characters);
        if (m_animation.character.empty() ? known.size() > 1 : !contains(known, m_animation.character))
            return;
        if (!m_animation.asksForSomething())
            m_problems.push_back(warningAt(m_pointer, "The animation asks for nothing",
                                           "Give it “constraints” (a path, keys or actions) or a “walk”."));
        if (m_animation.start)
            checkChoice(*m_animation.start, "/start");
        for (std::size_t i = 0; i < m_animation.constraints.size(); ++i)
            std::visit(
                [&](const auto& constraint) { check(constraint, "/constraints/" + std::to_string(i)); },
                m_animation.constraints[i]);
        checkJunctions(m_animation.junctions.banned, "/junctions/banned/");
        checkJunctions(m_animation.junctions.locked, "/junctions/locked/");
        checkJunctions(m_animation.junctions.chosen, "/junctions/chosen/");
        checkSpans(m_animation.junctions.walk, "/junctions/walk/");
        if (m_animation.walk)
            checkWalk(*m_animation.walk);
        if (m_animation.post.variations)
            checkRepeats(*m_animation.post.variations);
        checkPost(m_animation.post.steps);
        checkCamera();
    }

private:
    void invalid(const std::string& place, std::string reason, std::string remedy = {})
    {
        m_problems.push_back(invalidAt(m_pointer + place, std::move(reason), std::move(remedy)));
    }

    void checkSequence(const std::string& name, const std::string& place)
    {
        if (std::find(m_sequences.begin(), m_sequences.end(), name) != m_sequences.end())
            return;
        if (findSequence(m_project, name) != nullptr)
            invalid(place, "The sequence " + quoted(name) + " is not in the graph of this animation",
                    "It belongs to another character, or is itself made from this graph.");
        else
            invalid(place, "There is no sequence " + quoted(name),
                    meantOr(name, m_sequences, "Correct the name."));
    }

    void checkChoice(const FrameChoice& choice, const std::string& place)
    {
        if (!choice.sequence.empty())
            checkSequence(choice.sequence, place + "/sequence");
        if (choice.label.empty())
            return;
        std::vector<std::string> labels;
        for (const std::string& name : m_sequences) {
            for (const LabelSpan& span : findSequence(m_project, name)->labels)
                labels.push_back(span.label);
        }
        if (std::find(labels.begin(), labels.end(), choice.label) == labels.end())
            m_problems.push_back(
                warningAt(m_pointer + place + "/label", "No sequence has the label " + quoted(choice.label),
                          meantOr(choice.label, labels, "Give some frames of a sequence this label.")));
    }

    void checkPositive(const std::optional<double>& number, const std::string& place, const char* what)
    {
        if (number && !(*number > 0 && std::isfinite(*number)))
            invalid(place, std::string(what) + " must be above zero");
    }

    void check(const KeyEntry& key, const std::string& place)
    {
        checkSequence(key.sequence, place + "/sequence");
        if (m_lastKey && key.time >= 0 && key.time <= *m_lastKey)
            invalid(place + "/time", "The keys are out of order: this one is not later than the one before",
                    "Sort the keys by their times.");
        m_lastKey = std::max(m_lastKey.value_or(0), key.time);
    }

    void check(const PathEntry& path, const std::string& place)
    {
        if (m_hasPath)
            invalid(place, "There are two paths here", "Join them to one.");
        m_hasPath = true;
        if (path.points.size() < 2)
            invalid(place + "/points", "A path needs two points at least");
        else if (path.curve == PathCurve::Bezier && path.points.size() % 3 != 1)
            invalid(place + "/points", "A Bézier path has two handles between each two points",
                    "Write point, handle, handle, point, …");
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            if (!path.points[i].allFinite())
                invalid(place + "/points/" + std::to_string(i), "A coordinate is not a finite number");
        }
        for (std::size_t i = 0; i < path.spans.size(); ++i) {
            const PathSpanEntry& span = path.spans[i];
            const std::string own = place + "/spans/" + std::to_string(i);
            if (!(span.from >= 0) || !(span.to > span.from))
                invalid(own, "The span must go from a length, in the project's unit, to a greater one");
            if (span.frames)
                checkChoice(*span.frames, own);
        }
        for (std::size_t i = 0; i < path.obstacles.size(); ++i) {
            const ObstacleEntry& obstacle = path.obstacles[i];
            const std::string own = place + "/obstacles/" + std::to_string(i);
            if (obstacle.isDisc())
                checkPositive(obstacle.radius, own + "/radius", "A radius");
            else if (obstacle.corners.size() < 3)
                invalid(own + "/polygon", "A polygon needs three corners at least");
        }
        checkPlaces(path, place);
    }

    /// Places that are far off, which a slip of the keyboard makes.
    void checkPlaces(const PathEntry& path, const std::string& place)
    {
        const double farthest = farthestPlace(m_project.settings.axes.metresPerUnit);
        const auto isFar = [&](const auto& point) {
            return point.allFinite() && point.template lpNorm<Eigen::Infinity>() > farthest;
        };
        const auto far = [&](const std::string& own) {
            invalid(own, "Places lie at most 10 km from the origin",
                    "Write lengths in the project's unit, and mind the decimal point.");
        };
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            if (isFar(path.points[i]))
                far(place + "/points/" + std::to_string(i));
        }
        for (std::size_t i = 0; i < path.obstacles.size(); ++i) {
            const ObstacleEntry& obstacle = path.obstacles[i];
            const std::string own = place + "/obstacles/" + std::to_string(i);
            if (obstacle.radius > farthest)
                far(own + "/radius");
            if (std::ranges::any_of(obstacle.corners, isFar))
                far(own);
        }
        if (path.clearance > farthest)
            far(place + "/clearance");
    }

    void check(const ActionEntry& action, const std::string& place) { checkChoice(action.frames, place); }

    void checkJunctions(const std::vector<JunctionEntry>& junctions, const std::string& place)
    {
        for (std::size_t i = 0; i < junctions.size(); ++i) {
            checkSequence(junctions[i].from.sequence, place + std::to_string(i) + "/0");
            checkSequence(junctions[i].to.sequence, place + std::to_string(i) + "/1");
        }
    }

    void checkWalk(const WalkEntry& walk)
    {
        if (walk.spans.empty())
            invalid("/walk", "The walk has no spans",
                    "Write {\"sequence\": NAME, \"frames\": [first, last]}, one for each part.");
        checkSpans(walk.spans, "/walk/spans/");
    }

    void checkSpans(const std::vector<WalkSpanEntry>& spans, const std::string& place)
    {
        for (std::size_t i = 0; i < spans.size(); ++i) {
            checkSequence(spans[i].sequence, place + std::to_string(i) + "/sequence");
        }
    }

    void checkRepeats(const VariedRepeats& repeats)
    {
        std::vector<std::string> known;
        for (const VariationEntry& entry : m_project.variations) {
            if (characterNameOf(m_project, entry) == characterNameOf(m_project, m_animation))
                known.push_back(entry.name);
        }
        if (!repeats.from.empty() && std::find(known.begin(), known.end(), repeats.from) == known.end())
            invalid("/post/variations/from",
                    "There are no variations " + quoted(repeats.from) + " of the character",
                    meantOr(repeats.from, known, "Add them under “variations”."));
        else if (clipsDrawnFrom(m_project, m_animation).empty())
            m_problems.push_back(warningAt(m_pointer + "/post/variations",
                                           "There are no variations to draw from",
                                           "Give “variations” of takes of the graph “samples”."));
    }

    void checkPost(const PostProcessing& post)
    {
        if (post.repeats > 1 && !post.loop)
            invalid("/post/repeats", "Only a loop can be repeated", "Add “loop”: true.");
        if (!post.retime)
            return;
        if (const auto* factor = std::get_if<RetimeFactor>(&post.retime->time)) {
            checkPositive(factor->value, "/post/retime/factor", "The factor");
            if (factor->value > greatestFactor)
                invalid("/post/retime/factor", "A clip is slowed to at most 1000 times its length",
                        "Write 2 for half the speed.");
        } else if (const auto* duration = std::get_if<Seconds>(&post.retime->time)) {
            checkPositive(duration->value, "/post/retime/duration", "The duration");
            checkWithinAnHour(*duration, "/post/retime/duration");
        } else {
            checkCurve(std::get<RetimeSettings::Curve>(post.retime->time), "/post/retime/curve");
        }
    }

    void checkWithinAnHour(Seconds time, const std::string& place)
    {
        if (std::abs(time.value) > 3600)
            invalid(place, "An animation lasts at most an hour, 3600 seconds",
                    "Write an earlier time, in seconds.");
    }

    void checkCurve(const RetimeSettings::Curve& curve, const std::string& place)
    {
        if (curve.size() < 2)
            invalid(place, "A curve of times needs two points at least");
        for (std::size_t i = 0; i < curve.size(); ++i)
            checkWithinAnHour(curve[i].output, place + "/" + std::to_string(i));
        for (std::size_t i = 1; i < curve.size(); ++i) {
            if (!(curve[i].output.value > curve[i - 1].output.value) ||
                !(curve[i].clip.value >= curve[i - 1].clip.value))
                invalid(place + "/" + std::to_string(i), "The times of the curve do not increase",
                        "Sort its points by their times.");
        }
    }

    void checkCamera()
    {
        for (std::size_t i = 1; i < m_animation.camera.size(); ++i) {
            const double time = m_animation.camera[i].key.time;
            if (time >= 0 && time <= m_animation.camera[i - 1].key.time)
                invalid("/camera/" + std::to_string(i) + "/time",
                        "The camera keys are out of order: this one is not later than the one before",
                        "Sort the keys by their times.");
        }
    }

    const Project& m_project;
    const AnimationEntry& m_animation;
    std::string m_pointer;
    ProjectProblems& m_problems;
    std::vector<std::string> m_sequences; ///< of the graph
    std::optional<double> m_lastKey;
    bool m_hasPath = false;
};

} // namespace

void validateAnimations(const Project& project, ProjectProblems& problems)
{
    for (std::size_t i = 0; i < project.animations.size(); ++i)
        AnimationValidator(project, project.animations[i], "/animations/" + std::to_string(i), problems)
            .run();
}

} // namespace quadrille

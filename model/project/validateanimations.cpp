// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/validateanimations.h"

#include "model/project/madeclips.h"
#include "model/project/opensequence.h"
#include "model/project/validationtexts.h"
#include "model/project/variedrepeats.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

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
        if (!checkCharacter())
            return;
        if (m_animation.constraints.empty() && !m_animation.walk)
            m_problems.push_back(warningAt(m_pointer, "The animation asks for nothing",
                                           "Give it “constraints” (a path, keys or actions) or a “walk”."));
        if (m_animation.start)
            checkChoice(*m_animation.start, "/start");
        for (std::size_t i = 0; i < m_animation.constraints.size(); ++i)
            std::visit(
                [&](const auto& constraint) { check(constraint, "/constraints/" + std::to_string(i)); },
                m_animation.constraints[i]);
        checkSearch();
        checkJunctions(m_animation.junctions.banned, "/junctions/banned/");
        checkJunctions(m_animation.junctions.locked, "/junctions/locked/");
        checkJunctions(m_animation.junctions.chosen, "/junctions/chosen/");
        checkSpans(m_animation.junctions.walk, "/junctions/walk/");
        if (m_animation.walk)
            checkWalk(*m_animation.walk);
        if (m_animation.post.variations)
            checkRepeats(*m_animation.post.variations);
        checkPost(m_animation.post.steps);
        if (m_animation.audio)
            checkAudio(*m_animation.audio);
        checkCamera();
    }

private:
    void invalid(const std::string& place, std::string reason, std::string remedy = {})
    {
        m_problems.push_back(invalidAt(m_pointer + place, std::move(reason), std::move(remedy)));
    }

    bool checkCharacter()
    {
        const auto known = namesOf(m_project.characters);
        if (m_animation.character.empty() && known.size() > 1) {
            invalid("", "“character” is missing here", "The project has several characters.");
            return false;
        }
        if (!m_animation.character.empty() &&
            std::find(known.begin(), known.end(), m_animation.character) == known.end()) {
            invalid("/character", "There is no character " + quoted(m_animation.character),
                    meantOr(m_animation.character, known, "Add it under “characters”."));
            return false;
        }
        return true;
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

    void checkRange(const std::optional<FrameRange>& range, const std::string& place)
    {
        if (range && range->count() == 0)
            invalid(place, "The range ends before it begins",
                    "Write [first, last], zero-based, both included.");
    }

    void checkChoice(const FrameChoice& choice, const std::string& place)
    {
        if (!choice.sequence.empty())
            checkSequence(choice.sequence, place + "/sequence");
        checkRange(choice.range, place + "/range");
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
        if (key.frame.value < 0)
            invalid(place + "/frame", "Frames are counted from 0");
        if (!(key.time >= 0) || !std::isfinite(key.time))
            invalid(place + "/time", "The time of a key is below zero", "Write seconds from the start.");
        else if (m_lastKey && key.time <= *m_lastKey)
            invalid(place + "/time", "The keys are out of order: this one is not later than the one before",
                    "Sort the keys by their times.");
        if (key.tolerance && !(*key.tolerance >= 0))
            invalid(place + "/tolerance", "The tolerance is below zero");
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
            checkPositive(span.duration, own + "/duration", "A duration");
        }
        for (std::size_t i = 0; i < path.obstacles.size(); ++i) {
            const ObstacleEntry& obstacle = path.obstacles[i];
            const std::string own = place + "/obstacles/" + std::to_string(i);
            if (obstacle.isDisc())
                checkPositive(obstacle.radius, own + "/radius", "A radius");
            else if (obstacle.corners.size() < 3)
                invalid(own + "/polygon", "A polygon needs three corners at least");
        }
        if (!(path.clearance >= 0))
            invalid(place + "/clearance", "The clearance is below zero");
    }

    void check(const ActionEntry& action, const std::string& place)
    {
        checkChoice(action.frames, place);
        if (action.repeat < 1)
            invalid(place + "/repeat", "An action is performed once at least");
        checkPositive(action.duration, place + "/duration", "A duration");
        if (action.leastShare && !(*action.leastShare > 0 && *action.leastShare <= 1))
            invalid(place + "/least_share", "The share must be above 0 and at most 1");
    }

    void checkSearch()
    {
        const SearchEntry& search = m_animation.search;
        if (search.budget && *search.budget < 1)
            invalid("/search/budget", "The budget must be one expansion at least");
        if (search.beta && !(*search.beta >= 0))
            invalid("/search/beta", "Beta is below zero");
        if (search.mu && !(*search.mu >= 0))
            invalid("/search/mu", "Mu is below zero");
        if (search.dwell && !(*search.dwell >= 0))
            invalid("/search/dwell", "The least time in a take is below zero");
        if (search.deadZone && !(*search.deadZone >= 0))
            invalid("/search/dead_zone", "The dead zone is below zero");
        if (search.steering && !(*search.steering >= 0))
            invalid("/search/steering", "The steering is below zero");
    }

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
            checkRange(spans[i].frames, place + std::to_string(i) + "/frames");
        }
    }

    void checkRepeats(const VariedRepeats& repeats)
    {
        if (!(repeats.ease >= 0) || !std::isfinite(repeats.ease))
            invalid("/post/variations/ease", "The time of the ease is below zero", "Write seconds.");
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
        if (post.repeats < 1)
            invalid("/post/repeats", "A loop is shown once at least");
        else if (post.repeats > 1 && !post.loop)
            invalid("/post/repeats", "Only a loop can be repeated", "Add “loop”: true.");
        if (!post.retime)
            return;
        if (const auto* factor = std::get_if<RetimeFactor>(&post.retime->time)) {
            checkPositive(factor->value, "/post/retime/factor", "The factor");
        } else if (const auto* duration = std::get_if<Seconds>(&post.retime->time)) {
            checkPositive(duration->value, "/post/retime/duration", "The duration");
        } else {
            checkCurve(std::get<RetimeSettings::Curve>(post.retime->time), "/post/retime/curve");
        }
    }

    void checkCurve(const RetimeSettings::Curve& curve, const std::string& place)
    {
        if (curve.size() < 2)
            invalid(place, "A curve of times needs two points at least");
        for (std::size_t i = 1; i < curve.size(); ++i) {
            if (!(curve[i].output.value > curve[i - 1].output.value) ||
                !(curve[i].clip.value >= curve[i - 1].clip.value))
                invalid(place + "/" + std::to_string(i), "The times of the curve do not increase",
                        "Sort its points by their times.");
        }
    }

    void checkAudio(const AudioEntry& audio)
    {
        if (!std::isfinite(audio.offset))
            invalid("/audio/offset", "The offset of the sound is not a finite number");
        if (!(audio.gain >= -100 && audio.gain <= 40))
            invalid("/audio/gain", "The gain must be from -100 to 40 decibels");
    }

    void checkCamera()
    {
        for (std::size_t i = 0; i < m_animation.camera.size(); ++i) {
            const CameraKey& key = m_animation.camera[i].key;
            const std::string place = "/camera/" + std::to_string(i);
            if (!(key.time >= 0) || !std::isfinite(key.time))
                invalid(place + "/time", "The time of a camera key is below zero",
                        "Write seconds from the start.");
            else if (i > 0 && key.time <= m_animation.camera[i - 1].key.time)
                invalid(place + "/time",
                        "The camera keys are out of order: this one is not later than the one before",
                        "Sort the keys by their times.");
            checkPositive(key.distance, place + "/distance", "The distance of a camera");
            if (!(std::abs(key.elevation) <= 90))
                invalid(place + "/elevation", "The elevation must be from -90 to 90 degrees");
            if (!std::isfinite(key.azimuth))
                invalid(place + "/azimuth", "The azimuth is not a finite number");
            if (!(key.fieldOfView >= 1 && key.fieldOfView <= 170))
                invalid(place + "/fov", "The field of view must be from 1 to 170 degrees");
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

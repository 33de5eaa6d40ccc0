// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/poseheatmap.h"

#include "editor/jobs/jobrunner.h"
#include "model/transition/posedistance.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace quadrille {

namespace {

/// Ends that the range of colours may have, radians: few, so that colours stay the same while poses change.
constexpr std::array ends = {0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 1.5, 2.0};
constexpr double nearlyAll = 0.95;

double endFor(double high)
{
    const auto found = std::ranges::lower_bound(ends, high);
    return found == ends.end() ? ends.back() : *found;
}

} // namespace

PoseHeatMap::PoseHeatMap(widgets::Viewport& viewport, ClipScene& scene, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_viewport(viewport), m_scene(scene), m_jobs(jobs)
{
    connect(&scene, &ClipScene::changed, this, [this] {
        m_measured.reset();
        follow();
    });
    connect(&scene, &ClipScene::frameLoaded, this, &PoseHeatMap::follow);
}

PoseHeatMap::~PoseHeatMap() = default;

void PoseHeatMap::setOn(bool on)
{
    if (std::exchange(m_isOn, on) == on)
        return;
    m_greatest = 0;
    if (on) {
        follow();
        return;
    }
    clear();
    setState(State::Off);
}

std::optional<double> PoseHeatMap::distance() const
{
    return m_state == State::Shown ? std::optional(m_mean) : std::nullopt;
}

void PoseHeatMap::setState(State state)
{
    if (std::exchange(m_state, state) != state)
        emit changed();
}

void PoseHeatMap::clear()
{
    m_measured.reset();
    m_greatest = 0;
    if (m_job)
        m_job->cancel();
    for (const QString& name : m_scene.shown()) {
        if (const int figure = m_scene.figureOf(name); figure >= 0)
            m_viewport.setScalars(figure, {}, widgets::ScalarPlace::PerTriangle, {});
    }
}

std::optional<PoseHeatMap::Shown> PoseHeatMap::wanted() const
{
    const QStringList& names = m_scene.shown();
    const LoadedFrame* first = m_scene.loadedFrame(names[0]);
    const LoadedFrame* second = m_scene.loadedFrame(names[1]);
    if (first == nullptr || second == nullptr)
        return {};
    return Shown{names, first->frame, second->frame};
}

void PoseHeatMap::follow()
{
    if (!m_isOn)
        return;
    if (m_scene.shown().size() != 2) {
        clear();
        setState(State::NotTwo);
        return;
    }
    const auto shown = wanted();
    if (!shown) {
        setState(State::Waiting);
        return;
    }
    if (m_job == nullptr && shown != m_measured)
        start();
}

PoseHeatMap::Distances PoseHeatMap::measure(const MeshSequence& a, FrameIndex frameOfA, const MeshSequence& b,
                                            FrameIndex frameOfB)
{
    const std::vector<double> each = triangleDistances(
        a.frame(frameOfA).positions(), b.frame(frameOfB).positions(), a.topology->triangles());
    Distances result{.ofTriangles = {each.begin(), each.end()}};
    std::vector<double> measured;
    std::ranges::copy_if(each, std::back_inserter(measured), [](double d) { return std::isfinite(d); });
    if (measured.empty())
        return result;
    for (const double distance : measured)
        result.mean += distance;
    result.mean /= static_cast<double>(measured.size());
    const auto rank = static_cast<std::ptrdiff_t>(nearlyAll * static_cast<double>(measured.size() - 1));
    std::ranges::nth_element(measured, measured.begin() + rank);
    result.high = measured[static_cast<std::size_t>(rank)];
    return result;
}

void PoseHeatMap::start()
{
    const Shown shown = *wanted();
    const MeshSequence& a = *m_scene.sequenceOf(shown.names[0]);
    const MeshSequence& b = *m_scene.sequenceOf(shown.names[1]);
    if (a.topology->vertexCount() != b.topology->vertexCount() ||
        a.topology->triangles() != b.topology->triangles()) {
        clear();
        setState(State::DifferentMesh);
        return;
    }
    if (!m_measured || m_measured->names != shown.names) {
        m_greatest = 0;
        setState(State::Waiting);
    }
    m_measured = shown;
    m_job = m_jobs.start(
        {.name = tr("Pose distance of “%1” and “%2”").arg(shown.names[0], shown.names[1]),
         .receiver = this,
         .failed = [](const Error&) { /* told when the frame is shown */ },
         .background = true},
        [a, b, shown](const Progress& progress) {
            progress.report(0);
            return measure(a, shown.first, b, shown.second);
        },
        [this, shown](const Distances& distances) { apply(shown, distances); });
    connect(m_job, &Job::ended, this, [this] {
        m_job = nullptr;
        follow();
    });
}

void PoseHeatMap::apply(const Shown& shown, const Distances& distances)
{
    if (!m_isOn || shown.names != m_scene.shown())
        return;
    m_mean = distances.mean;
    m_greatest = std::max(m_greatest, endFor(distances.high));
    const widgets::ScalarRange range{.maximum = m_greatest,
                                     //: title of a legend; %1 is a number of radians
                                     .title =
                                         tr("Pose distance, mean %1").arg(QLocale().toString(m_mean, 'f', 3)),
                                     .unit = tr("rad")};
    for (const QString& name : shown.names) {
        const MeshSequence* sequence = m_scene.sequenceOf(name);
        if (sequence != nullptr && sequence->topology->triangles().size() == distances.ofTriangles.size())
            m_viewport.setScalars(m_scene.figureOf(name), distances.ofTriangles,
                                  widgets::ScalarPlace::PerTriangle, range);
    }
    m_state = State::Shown;
    emit changed();
}

} // namespace quadrille

#include "moc_poseheatmap.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/partcurvejobs.h"

#include "editor/jobs/jobrunner.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/variations/partedits.h"

#include <utility>

namespace quadrille {

PartCurveJobs::PartCurveJobs(const PartCurveContent& content, JobRunner& runner, QObject* parent)
    : QObject(parent), m_content(content), m_runner(runner)
{
}

void PartCurveJobs::run(const QString& name, const QString& text, Work work, const PartSelection& selection)
{
    if (m_job || !m_content.graph)
        return;
    emit begun();
    m_job = m_runner.start(
        {.name = name,
         .receiver = this,
         .stillStands = [this, body = m_content.body,
                         graph =
                             m_content.graph] { return body == m_content.body && graph == m_content.graph; },
         .failed = [this](const Error& error) { emit failed(error); }},
        [work = std::move(work), body = m_content.body](const Progress& progress) {
            return work(body, progress);
        },
        [this, text, selection](const BodyPartsEntry& after) { emit computed(text, after, selection); });
    connect(m_job, &Job::ended, this, [this] {
        m_job.clear();
        emit busyChanged();
    });
    emit busyChanged();
}

void PartCurveJobs::propose(const std::shared_ptr<const Topology>& topology, UpAxis up)
{
    if (!m_content.graph)
        return;
    run(PartCurveTool::tr("Proposing parts of the body"), PartCurveTool::tr("Propose parts"),
        [graph = m_content.graph, topology,
         settings = proposalSettings(*m_content.graph, up, m_content.drawing.overlap)](
            BodyPartsEntry body, const Progress& progress) {
            return withProposedParts(std::move(body), graph, topology, settings, progress);
        });
}

void PartCurveJobs::addPart(const NewPart& part)
{
    run(PartCurveTool::tr("Adding a part"), PartCurveTool::tr("Add a part"),
        [part, graph = m_content.graph, metres = m_content.drawing.overlap](BodyPartsEntry body,
                                                                            const Progress&) {
            return withNewPart(std::move(body), graph, part, metres);
        },
        {PartSelection::Kind::Part, part.name});
}

void PartCurveJobs::addSecondCurve()
{
    const PartCurveEntry* first = m_content.selectedCurve();
    if (first == nullptr)
        return;
    const std::string name = freeCurveName(m_content.body, first->curve.name);
    run(PartCurveTool::tr("Adding a second curve"), PartCurveTool::tr("Add a second curve"),
        [curve = *first, name, graph = m_content.graph,
         metres = m_content.drawing.overlap](BodyPartsEntry body, const Progress&) {
            return withSecondCurve(std::move(body), graph, curve, name, metres);
        },
        {PartSelection::Kind::Curve, name});
}

void PartCurveJobs::mirror()
{
    const auto plan = mirrorPlan(m_content, [](const std::string& name) {
        return PartCurveTool::tr("%1, mirrored").arg(QString::fromStdString(name)).toStdString();
    });
    if (!plan || isBusy() || !m_content.graph)
        return;
    auto known = std::make_shared<std::shared_ptr<const Symmetry>>(m_symmetry);
    run(
        PartCurveTool::tr("Mirroring"),
        plan->part ? PartCurveTool::tr("Mirror a part") : PartCurveTool::tr("Mirror a curve"),
        [graph = m_content.graph, plan = *plan, known](BodyPartsEntry body, const Progress& progress) {
            if (*known == nullptr)
                *known = std::make_shared<const Symmetry>(
                    findSymmetry(graph->topology(), graph->pose(), {}, progress));
            return withMirrored(std::move(body), graph, **known, plan);
        },
        plan->selection);
    connect(m_job, &Job::ended, this, [this, known, graph = m_content.graph] {
        if (graph == m_content.graph)
            m_symmetry = *known;
    });
}

void PartCurveJobs::shorten()
{
    const PartCurveEntry* curve = m_content.selectedCurve();
    if (curve == nullptr)
        return;
    run(
        PartCurveTool::tr("Shortening a curve"), PartCurveTool::tr("Shorten a curve"),
        [graph = m_content.graph, name = curve->curve.name,
         travel = m_content.drawing.overlap](BodyPartsEntry body, const Progress&) {
            return withShortenedCurve(std::move(body), graph, name, travel);
        },
        m_content.selected);
}

} // namespace quadrille

#include "moc_partcurvejobs.cpp"

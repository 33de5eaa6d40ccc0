// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What is done to whole curves and parts; what may take long, in jobs.
#include "editor/commands/variationedits.h"
#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/workspaces/variations/bodysurface.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/variations/partedits.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/geometry/curveedits.h"
#include "model/variation/parts/proposedparts.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace quadrille {

using widgets::MessageStrip;

namespace {

/// Height of a pose, metres.
double heightOf(Positions pose, UpAxis up)
{
    float lowest = std::numeric_limits<float>::max();
    float highest = std::numeric_limits<float>::lowest();
    for (const Vec3f& point : pose) {
        lowest = std::min(lowest, point[static_cast<int>(up)]);
        highest = std::max(highest, point[static_cast<int>(up)]);
    }
    return static_cast<double>(highest - lowest);
}

Vec3f middleOf(const SurfaceGraph& graph, std::span<const VertexIndex> curve)
{
    Vec3f sum = Vec3f::Zero();
    for (const VertexIndex vertex : curve)
        if (vertex.value < graph.vertexCount())
            sum += graph.pose()[vertex.value];
    return sum / static_cast<float>(std::max<std::size_t>(curve.size(), 1));
}

std::vector<VertexIndex> obstaclesIn(const BodyPartsEntry& body, const std::vector<std::string>& without)
{
    std::vector<VertexIndex> vertices;
    for (const PartCurveEntry& entry : body.curves)
        if (std::find(without.begin(), without.end(), entry.curve.name) == without.end())
            vertices.insert(vertices.end(), entry.curve.vertices.begin(), entry.curve.vertices.end());
    return vertices;
}

/// The second curve of a part: towards the end of the limb, or on its other side where there is no room.
PartCurveEntry secondCurve(const std::shared_ptr<const SurfaceGraph>& graph, const BodyPartsEntry& body,
                           const PartCurveEntry& first, const std::string& name, double metres)
{
    const std::vector<VertexIndex> obstacles = obstaclesIn(body, {first.curve.name});
    PartCurveEntry second;
    second.curve.name = name;
    try {
        second.curve.vertices =
            parallelCurve(*graph, first.curve.vertices, metres, CurveSide::Smaller, obstacles);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::CurveNoParallel)
            throw;
        second.curve.vertices =
            parallelCurve(*graph, first.curve.vertices, metres, CurveSide::Larger, obstacles);
    }
    second.points = guidesOf(graph, second.curve.vertices);
    return second;
}

/// Puts a curve in the place of one of the same name, or behind the others.
void putCurve(BodyPartsEntry& body, PartCurveEntry curve)
{
    if (PartCurveEntry* before = findCurve(body, curve.curve.name)) {
        curve.unknown = before->unknown;
        *before = std::move(curve);
    } else {
        body.curves.push_back(std::move(curve));
    }
}

} // namespace

void PartCurveTool::run(const QString& name, const QString& text,
                        std::function<BodyPartsEntry(BodyPartsEntry, const Progress&)> work,
                        const PartSelection& selectAfterwards)
{
    if (m_job || !m_shownGraph)
        return;
    emit told({});
    m_job = m_variation.context().jobs.start(
        {.name = name,
         .receiver = this,
         .stillStands = [this, body = m_body,
                         graph = m_shownGraph] { return body == m_body && graph == m_shownGraph; },
         .failed =
             [this](const Error& error) {
                 const ErrorText why = describe(error);
                 emit told({MessageStrip::Kind::Error, why.sentence, why.remedy});
             }},
        [work = std::move(work), body = m_body](const Progress& progress) { return work(body, progress); },
        [this, text, selectAfterwards](const BodyPartsEntry& after) {
            edit(text, QStringLiteral("parts"), [&after](BodyPartsEntry& body) { body = after; });
            if (selectAfterwards.kind != PartSelection::Kind::None)
                select(selectAfterwards);
        });
    connect(m_job, &Job::ended, this, [this] {
        m_job.clear();
        refreshActions();
        emit changed();
    });
    refreshActions();
    emit changed();
}

void PartCurveTool::propose()
{
    const auto pose = m_surface->pose();
    const EditorContext& context = m_variation.context();
    const MeshSequence* sequence =
        pose ? context.media.sequence(QString::fromStdString(pose->sequence)) : nullptr;
    if (sequence == nullptr || !m_shownGraph)
        return;
    emit panelRequested();
    ProposalSettings settings;
    settings.up = context.document.project().settings.axes.up;
    if (const double height = heightOf(m_shownGraph->pose(), settings.up); height > 0)
        settings.overlap = m_drawing.overlap / height;
    run(tr("Proposing parts of the body"), tr("Propose parts"),
        [graph = m_shownGraph, topology = sequence->topology, settings](BodyPartsEntry body,
                                                                        const Progress& progress) {
            const ProposedParts proposed = proposeParts(topology, graph->pose(), settings, progress);
            body.curves.clear();
            body.parts.clear();
            for (const PartCurve& curve : proposed.curves)
                body.curves.push_back(
                    {.curve = curve, .points = guidesOf(graph, curve.vertices), .unknown = {}});
            for (const PartDescription& part : proposed.parts)
                body.parts.push_back({.part = part, .unknown = {}});
            return body;
        });
}

void PartCurveTool::draw()
{
    using Mode = widgets::SurfaceCurveEditor::Mode;
    EditorContext& context = m_variation.context();
    context.actions.action(QStringLiteral("workspace.variations"))->trigger();
    context.actions.action(QStringLiteral("variations.parts.show"))->setChecked(true);
    emit panelRequested();
    m_variation.view().player().pause(); // what is clicked on is to stand still
    m_editor->setMode(m_editor->mode() == Mode::Draw ? Mode::Edit : Mode::Draw);
    m_variation.view().viewport().setTool(widgets::Viewport::Tool::Navigate);
    m_variation.view().viewport().setFocus();
}

void PartCurveTool::addPart()
{
    const std::vector<std::string> loose = looseCurves();
    if (loose.empty() || !m_shownGraph)
        return;
    const bool isChosen =
        selectedCurve() != nullptr && std::find(loose.begin(), loose.end(), m_selected.name) != loose.end();
    const std::string first = isChosen ? m_selected.name : loose.front();
    const PartCurveEntry curve = *findCurve(m_body, first);
    const Vec3f middle = middleOf(*m_shownGraph, curve.curve.vertices);
    std::string second;
    float nearest = std::numeric_limits<float>::max();
    for (const std::string& name : loose) {
        const float distance =
            (middleOf(*m_shownGraph, findCurve(m_body, name)->curve.vertices) - middle).norm();
        if (name != first && distance < nearest) {
            nearest = distance;
            second = name;
        }
    }
    const std::string part = freePartName(m_body, tr("part").toStdString());
    const std::string root = tr("body").toStdString();
    const std::string parent = m_cut.partOf(curve.curve.vertices);
    const PartSelection selection{PartSelection::Kind::Part, part};
    if (!second.empty()) {
        edit(tr("Add a part"), QStringLiteral("parts"), [&](BodyPartsEntry& body) {
            quadrille::addPart(body, part, root, parent, {first, second});
        });
        select(selection);
        return;
    }
    run(
        tr("Adding a part"), tr("Add a part"),
        [=, graph = m_shownGraph, metres = m_drawing.overlap](BodyPartsEntry body, const Progress&) {
            PartCurveEntry other =
                secondCurve(graph, body, curve, freeCurveName(body, curve.curve.name), metres);
            quadrille::addPart(body, part, root, parent, {first, other.curve.name});
            body.curves.push_back(std::move(other));
            return body;
        },
        selection);
}

void PartCurveTool::addSecondCurve()
{
    const PartCurveEntry* first = selectedCurve();
    if (first == nullptr)
        return;
    const std::string name = freeCurveName(m_body, first->curve.name);
    run(tr("Adding a second curve"), tr("Add a second curve"),
        [curve = *first, name, graph = m_shownGraph, metres = m_drawing.overlap](BodyPartsEntry body,
                                                                                 const Progress&) {
            body.curves.push_back(secondCurve(graph, body, curve, name, metres));
            return body;
        },
        {PartSelection::Kind::Curve, name});
}

void PartCurveTool::mirror()
{
    const PartEntry* part =
        m_selected.kind == PartSelection::Kind::Part ? findPart(m_body, m_selected.name) : nullptr;
    const std::vector<std::string> curves = part != nullptr ? part->part.curves
                                            : selectedCurve() != nullptr
                                                ? std::vector<std::string>{m_selected.name}
                                                : std::vector<std::string>();
    if (curves.empty() || !m_shownGraph)
        return;
    const auto otherName = [](const std::string& name) {
        const std::string other = otherSideName(name);
        return other.empty() ? tr("%1, mirrored").arg(QString::fromStdString(name)).toStdString() : other;
    };
    std::map<std::string, std::string> names;
    for (const std::string& curve : curves)
        names[curve] = otherName(curve);
    const PartSelection selection{m_selected.kind, otherName(m_selected.name)};
    std::optional<PartEntry> other;
    if (part != nullptr) {
        other = *part;
        other->part.name = selection.name;
        if (const std::string parent = otherSideName(part->part.parent); findPart(m_body, parent) != nullptr)
            other->part.parent = parent;
        for (std::string& curve : other->part.curves)
            curve = names[curve];
    }
    auto known = std::make_shared<std::shared_ptr<const Symmetry>>(m_symmetry);
    run(
        tr("Mirroring"), part != nullptr ? tr("Mirror a part") : tr("Mirror a curve"),
        [graph = m_shownGraph, names, other, known](BodyPartsEntry body, const Progress& progress) {
            if (*known == nullptr)
                *known = std::make_shared<const Symmetry>(
                    findSymmetry(graph->topology(), graph->pose(), {}, progress));
            for (const auto& [from, to] : names) {
                const PartCurveEntry* own = findCurve(body, from);
                if (own == nullptr)
                    continue;
                GuidedCurve mirrored =
                    mirroredCurve(graph, **known, {.points = own->points, .vertices = own->curve.vertices});
                putCurve(body, {.curve = {.name = to, .vertices = std::move(mirrored.vertices)},
                                .points = std::move(mirrored.points),
                                .unknown = {}});
            }
            if (other) {
                if (PartEntry* before = findPart(body, other->part.name))
                    before->part = other->part;
                else
                    body.parts.push_back(*other);
            }
            return body;
        },
        selection);
    if (m_job)
        connect(m_job, &Job::ended, this, [this, known, graph = m_shownGraph] {
            if (graph == m_shownGraph)
                m_symmetry = *known;
        });
}

void PartCurveTool::shorten()
{
    const PartCurveEntry* curve = selectedCurve();
    if (curve == nullptr || !m_shownGraph)
        return;
    run(
        tr("Shortening a curve"), tr("Shorten a curve"),
        [graph = m_shownGraph, name = curve->curve.name, travel = m_drawing.overlap](BodyPartsEntry body,
                                                                                     const Progress&) {
            PartCurveEntry& own = *findCurve(body, name);
            own.curve.vertices =
                shortenedCurve(*graph, own.curve.vertices, travel, obstaclesIn(body, {name}));
            own.points = guidesOf(graph, own.curve.vertices);
            return body;
        },
        m_selected);
}

void PartCurveTool::removeSelected()
{
    const QString name = QString::fromStdString(m_selected.name);
    if (m_selected.kind == PartSelection::Kind::Part) {
        edit(tr("Delete a part"), QStringLiteral("parts"),
             [part = m_selected.name](BodyPartsEntry& body) { removePart(body, part); });
        return;
    }
    if (selectedCurve() == nullptr)
        return;
    const std::vector<std::string> users = partsWith(m_body, m_selected.name);
    edit(tr("Delete a curve"), QStringLiteral("curves"),
         [curve = m_selected.name](BodyPartsEntry& body) { removeCurve(body, curve); });
    if (!users.empty())
        emit told({MessageStrip::Kind::Warning,
                   tr("The curve “%1” bounded the part “%2”, which lacks a curve now.")
                       .arg(name, QString::fromStdString(users.front())),
                   tr("Undo, draw another one, or choose one for the part.")});
}

bool PartCurveTool::rename(const PartSelection& which, const QString& name)
{
    const std::string wanted = name.trimmed().toStdString();
    if (wanted.empty() || wanted == which.name)
        return wanted == which.name;
    const bool isCurve = which.kind == PartSelection::Kind::Curve;
    const bool isTaken = isCurve ? findCurve(m_body, wanted) != nullptr : findPart(m_body, wanted) != nullptr;
    if (isTaken) {
        emit told({MessageStrip::Kind::Error,
                   (isCurve ? tr("There is a curve “%1” already.") : tr("There is a part “%1” already."))
                       .arg(name.trimmed()),
                   tr("Choose another name.")});
        return false;
    }
    const PartSelection renamed{which.kind, wanted};
    const bool wasSelected = m_selected == which;
    edit(isCurve ? tr("Rename a curve") : tr("Rename a part"), QStringLiteral("names"),
         [&](BodyPartsEntry& body) {
             if (isCurve)
                 renameCurve(body, which.name, wanted);
             else
                 renamePart(body, which.name, wanted);
         });
    if (wasSelected)
        select(renamed);
    return true;
}

void PartCurveTool::takeShownPose()
{
    const ClipScene& scene = m_variation.view().scene();
    if (scene.shown().isEmpty())
        return;
    const NamedFrame pose{.sequence = scene.shown().back().toStdString(), .frame = scene.frame()};
    edit(tr("Choose the pose that curves are drawn in"), QStringLiteral("pose"),
         [&pose](BodyPartsEntry& body) { body.pose = pose; });
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/transfer/currenttransfer.h"

#include "editor/commands/projectionedits.h"
#include "editor/commands/transferedits.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"

#include <algorithm>
#include <limits>

namespace quadrille {

CurrentTransfer::CurrentTransfer(EditorContext& context, SceneView& view, QObject* parent)
    : QObject(parent), m_context(context), m_view(view)
{
    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.touches(Section::Transfers) || event.touches(Section::Sequences) ||
            event.touches(Section::Characters) || event.touches(Section::Animations))
            emit changed();
    });
    connect(&context.selection, &Selection::changed, this, [this] {
        emit changed();
        emit resultChanged();
    });
    connect(&context.transfers, &TransferResults::changed, this, [this](const QString& name) {
        if (name == this->name())
            emit resultChanged();
    });
}

const QString& CurrentTransfer::name() const
{
    return m_context.selection.shownTransfer();
}

const TransferEntry* CurrentTransfer::entry() const
{
    return findTransfer(m_context.document.project(), name().toStdString());
}

const TransferResults::State* CurrentTransfer::state() const
{
    return m_context.transfers.resultState(name());
}

TransferPreviewPointer CurrentTransfer::preview() const
{
    const TransferResults::State* found = state();
    const TransferEntry* own = entry();
    if (found == nullptr || own == nullptr || found->preview == nullptr ||
        found->preview->entry.clip != own->clip || found->preview->entry.target != own->target)
        return nullptr;
    return found->preview;
}

TransferResultPointer CurrentTransfer::result() const
{
    const TransferResults::State* found = state();
    const bool isAsked = found != nullptr && found->result != nullptr && entry() != nullptr &&
                         found->result->entry == *entry();
    return isAsked ? found->result : nullptr;
}

std::vector<ProposedPair> CurrentTransfer::pairs() const
{
    const TransferPreviewPointer shown = preview();
    if (entry() == nullptr)
        return {};
    if (entry()->pairs.empty())
        return shown != nullptr && shown->entry.pairs.empty() ? shown->pairs : std::vector<ProposedPair>();
    std::vector<ProposedPair> all;
    for (const TrianglePair& pair : entry()->pairs) {
        all.push_back({pair, std::numeric_limits<double>::quiet_NaN()});
        ProposedPair& own = all.back();
        if (shown != nullptr && shown->alignment && pair.onTemplate.value < shown->templatePlaces->size() &&
            pair.onTarget.value < shown->targetPlaces->size())
            own.quality = shown->alignment->likeness(pair);
    }
    return all;
}

std::optional<BodyRegion> CurrentTransfer::regionOf(const TrianglePair& pair) const
{
    const TransferPreviewPointer shown = preview();
    if (shown == nullptr || !shown->templatePlaces ||
        pair.onTemplate.value >= shown->templatePlaces->size() ||
        !shown->templatePlaces->knows(pair.onTemplate))
        return std::nullopt;
    return shown->templatePlaces->regionOf(pair.onTemplate);
}

std::vector<BodyRegion> CurrentTransfer::regionsWithout() const
{
    const TransferPreviewPointer shown = preview();
    if (shown == nullptr || !shown->templatePlaces)
        return {};
    std::vector<TrianglePair> all = plainPairs();
    std::erase_if(all, [&](const TrianglePair& pair) {
        return pair.onTemplate.value >= shown->templatePlaces->size();
    });
    return regionsWithoutPairs(all, *shown->templatePlaces);
}

void CurrentTransfer::select(int pair)
{
    if (pair == m_selected)
        return;
    m_selected = pair;
    emit selectionChanged();
}

void CurrentTransfer::setShowsReference(bool shows)
{
    if (shows == m_showsReference)
        return;
    m_showsReference = shows;
    emit showsReferenceChanged();
}

void CurrentTransfer::edit(const QString& text, const QString& property, const Edit& edit, EditPhase phase)
{
    if (entry() == nullptr)
        return;
    TransferEntry after = *entry();
    edit(after);
    setTransfer(m_context.document, name(), text, property, std::move(after), phase);
}

void CurrentTransfer::setPairs(const QString& text, std::vector<TrianglePair> pairs, EditPhase phase)
{
    edit(
        text, QStringLiteral("pairs"), [&](TransferEntry& entry) { entry.pairs = std::move(pairs); }, phase);
}

std::vector<TrianglePair> CurrentTransfer::plainPairs() const
{
    std::vector<TrianglePair> all;
    for (const ProposedPair& each : pairs())
        all.push_back(each.pair);
    return all;
}

bool CurrentTransfer::hasTarget(const std::vector<TrianglePair>& pairs, TriangleIndex triangle) const
{
    return std::ranges::find(pairs, triangle, &TrianglePair::onTarget) != pairs.end();
}

bool CurrentTransfer::addPair(const TrianglePair& pair)
{
    std::vector<TrianglePair> all = plainPairs();
    if (hasTarget(all, pair.onTarget))
        return false;
    all.push_back(pair);
    const auto added = static_cast<int>(all.size()) - 1;
    setPairs(tr("Pair triangles"), std::move(all));
    select(added);
    return true;
}

bool CurrentTransfer::movePair(int pair, int side, std::uint32_t triangle, EditPhase phase)
{
    std::vector<TrianglePair> all = plainPairs();
    const auto at = static_cast<std::size_t>(pair);
    if (pair < 0 || at >= all.size())
        return false;
    const TriangleIndex to(triangle);
    if (side == 1 && to != all[at].onTarget && hasTarget(all, to))
        return false;
    (side == 0 ? all[at].onTemplate : all[at].onTarget) = to;
    setPairs(tr("Move pair %1").arg(pair + 1), std::move(all), phase);
    return true;
}

void CurrentTransfer::removePair(int pair)
{
    std::vector<TrianglePair> all = plainPairs();
    if (pair < 0 || static_cast<std::size_t>(pair) >= all.size())
        return;
    all.erase(all.begin() + pair);
    select(-1);
    setPairs(tr("Remove pair %1").arg(pair + 1), std::move(all));
}

bool CurrentTransfer::mirrorPair(int pair)
{
    const TransferPreviewPointer shown = preview();
    const std::vector<TrianglePair> all = plainPairs();
    if (pair < 0 || static_cast<std::size_t>(pair) >= all.size() || shown == nullptr ||
        !shown->templatePlaces || !shown->targetPlaces)
        return false;
    const auto mirrored =
        mirroredPair(all[static_cast<std::size_t>(pair)], *shown->templatePlaces, *shown->targetPlaces);
    return mirrored && addPair(*mirrored);
}

std::optional<std::uint32_t> CurrentTransfer::counterpart(int side, std::uint32_t triangle) const
{
    const TransferPreviewPointer shown = preview();
    if (shown == nullptr || !shown->alignment)
        return std::nullopt;
    const BodyPlaces& from = side == 0 ? *shown->templatePlaces : *shown->targetPlaces;
    if (triangle >= from.size())
        return std::nullopt;
    const TriangleIndex picked(triangle);
    const auto found = side == 0 ? shown->alignment->onTarget(picked) : shown->alignment->onTemplate(picked);
    return found ? std::optional(static_cast<std::uint32_t>(found->value)) : std::nullopt;
}

QString CurrentTransfer::add()
{
    const Project& project = m_context.document.project();
    TransferEntry transfer;
    const QString& shown = m_context.selection.shownSequence();
    transfer.clip = "sequences/" + shown.toStdString();
    const std::string own = characterOfClip(project, transfer.clip);
    transfer.target.sequence = shown.toStdString();
    for (const SequenceEntry& sequence : project.sequences) {
        if (characterOfClip(project, "sequences/" + sequence.name) != own) {
            transfer.target.sequence = sequence.name;
            break;
        }
    }
    transfer.name = tr("%1 by %2").arg(shown, QString::fromStdString(transfer.target.sequence)).toStdString();
    QString added = addTransfer(m_context.document, std::move(transfer));
    m_context.selection.select({Section::Transfers, added});
    return added;
}

QString CurrentTransfer::addProjection(const QString& cameras)
{
    ProjectionEntry projection;
    const bool isOfTransfer =
        entry() != nullptr && m_context.selection.current() == EntryRef{Section::Transfers, name()};
    const QString clip = isOfTransfer ? name() : m_context.selection.shownSequence();
    projection.clip = (isOfTransfer ? "transfers/" : "sequences/") + clip.toStdString();
    projection.cameras = toPath(cameras).generic_string();
    projection.name = tr("%1, filmed").arg(clip).toStdString();
    QString added = quadrille::addProjection(m_context.document, std::move(projection));
    m_context.selection.select({Section::Projections, added});
    return added;
}

QString CurrentTransfer::regionName(BodyRegion region)
{
    switch (region) {
    case BodyRegion::Trunk:
        return tr("trunk");
    case BodyRegion::Head:
        return tr("head");
    case BodyRegion::LeftUpperArm:
        return tr("left upper arm");
    case BodyRegion::LeftLowerArm:
        return tr("left lower arm");
    case BodyRegion::RightUpperArm:
        return tr("right upper arm");
    case BodyRegion::RightLowerArm:
        return tr("right lower arm");
    case BodyRegion::LeftThigh:
        return tr("left thigh");
    case BodyRegion::LeftShin:
        return tr("left shin");
    case BodyRegion::RightThigh:
        return tr("right thigh");
    case BodyRegion::RightShin:
        return tr("right shin");
    }
    return {};
}

} // namespace quadrille

#include "moc_currenttransfer.cpp"

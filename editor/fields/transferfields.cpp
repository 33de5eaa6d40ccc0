// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/transferfields.h"

#include "editor/fields/clipchoice.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/project.h"

#include <algorithm>

namespace quadrille {

namespace {

QString poseText(const NamedFrame& pose)
{
    return QStringLiteral("%1 %2").arg(QString::fromStdString(pose.sequence)).arg(pose.frame.value);
}

} // namespace

std::vector<FieldItem<std::string>> clipItems(const Project& project, const TransferEntry& transfer)
{
    std::vector<FieldItem<std::string>> items;
    const auto add = [&](const char* section, const std::string& name) {
        const std::string clip = section + name;
        items.push_back({nameOfClip(QString::fromStdString(clip)), clip});
    };
    for (const SequenceEntry& each : project.sequences)
        add("sequences/", each.name);
    for (const AnimationEntry& each : project.animations)
        add("animations/", each.name);
    for (const TransferEntry& each : project.transfers) {
        if (each.name != transfer.name)
            add("transfers/", each.name);
    }
    const auto isOwn = [&](const auto& item) { return item.value == transfer.clip; };
    if (!transfer.clip.empty() && std::ranges::none_of(items, isOwn))
        items.push_back({nameOfClip(QString::fromStdString(transfer.clip)), transfer.clip});
    return items;
}

std::vector<FieldItem<std::string>> targetItems(const Project& project)
{
    std::vector<FieldItem<std::string>> items;
    for (const SequenceEntry& each : project.sequences)
        items.push_back({QString::fromStdString(each.name), each.name});
    return items;
}

std::vector<FieldItem<std::optional<NamedFrame>>> referenceItems(const Project& project,
                                                                 const TransferEntry& transfer)
{
    std::vector<FieldItem<std::optional<NamedFrame>>> items;
    items.push_back({TransferTexts::tr("The most alike"), std::nullopt});
    TransferEntry found = transfer;
    found.reference.reset();
    for (const std::string& take : templateSequences(project, found)) {
        const NamedFrame first{take, FrameIndex(0)};
        items.push_back({poseText(first), first});
    }
    const auto isOwn = [&](const auto& item) { return item.value == transfer.reference; };
    if (std::ranges::none_of(items, isOwn))
        items.push_back({poseText(*transfer.reference), transfer.reference});
    return items;
}

std::vector<FieldItem<std::string>> truthItems(const Project& project, const TransferEntry& transfer)
{
    std::vector<FieldItem<std::string>> items;
    items.push_back({TransferTexts::tr("Not known"), {}});
    const std::string character = characterOfClip(project, "sequences/" + transfer.target.sequence);
    for (const SequenceEntry& each : project.sequences) {
        const std::string clip = "sequences/" + each.name;
        if (characterOfClip(project, clip) == character && clip != transfer.clip)
            items.push_back({QString::fromStdString(each.name), clip});
    }
    const auto isOwn = [&](const auto& item) { return item.value == transfer.truth; };
    if (std::ranges::none_of(items, isOwn))
        items.push_back({nameOfClip(QString::fromStdString(transfer.truth)), transfer.truth});
    return items;
}

void setClip(TransferEntry& transfer, const std::string& clip, const Project& project)
{
    if (clip != transfer.clip)
        transfer.truth.clear();
    if (characterOfClip(project, clip) != characterOfClip(project, transfer.clip)) {
        transfer.pairs.clear();
        transfer.reference.reset();
    }
    transfer.clip = clip;
}

void setTarget(TransferEntry& transfer, const std::string& sequence, const Project& project)
{
    if (characterOfClip(project, "sequences/" + sequence) !=
        characterOfClip(project, "sequences/" + transfer.target.sequence)) {
        transfer.pairs.clear();
        transfer.truth.clear();
    }
    transfer.target = {sequence, FrameIndex(0)};
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/bodypose.h"

#include "model/project/document/throwinvalid.h"

namespace quadrille {

std::vector<Vec3f> poseInMetres(SequenceOpener& opener, const NamedFrame& frame, const Progress& progress)
{
    const auto opened = opener.open(frame.sequence, Progress(progress.token()));
    const MeshSequence& sequence = opened->sequence;
    if (frame.frame.value < 0 || frame.frame.value >= sequence.frameCount())
        throwInvalid("“" + frame.sequence + "” has no frame " + std::to_string(frame.frame.value),
                     "Write a frame from 0 to " + std::to_string(sequence.frameCount() - 1) + ".");
    const auto metres = static_cast<float>(opener.project().settings.axes.metresPerUnit);
    const Frame captured = sequence.frame(frame.frame);
    std::vector<Vec3f> pose(captured.positions().begin(), captured.positions().end());
    for (Vec3f& position : pose)
        position *= metres;
    return pose;
}

BodyParts cutParts(const Topology& topology, Positions pose, const BodyPartsEntry& entry)
{
    std::vector<PartCurve> curves;
    for (const PartCurveEntry& curve : entry.curves)
        curves.push_back(curve.curve);
    std::vector<PartDescription> descriptions;
    for (const PartEntry& part : entry.parts)
        descriptions.push_back(part.part);
    return cutIntoParts(topology, pose, curves, descriptions);
}

} // namespace quadrille

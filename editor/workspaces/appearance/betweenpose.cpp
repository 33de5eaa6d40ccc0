// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/betweenpose.h"

#include "model/transition/poseinterpolation.h"

#include <algorithm>
#include <array>
#include <mutex>

namespace quadrille {

namespace {

class BetweenPose : public FrameSource
{
public:
    BetweenPose(std::array<MeshSequence, 2> sequences, std::array<FrameIndex, 2> frames, double weight,
                std::int64_t count)
        : m_sequences(std::move(sequences)), m_frames(frames), m_weight(weight), m_count(count)
    {
    }

    std::int64_t frameCount() const override { return m_count; }
    std::uint32_t vertexCount() const override { return m_sequences[0].topology->vertexCount(); }
    void read(FrameIndex, MutablePositions out) const override
    {
        std::call_once(m_once, [this] {
            m_pose = interpolatePoses(m_sequences[0].topology, m_sequences[0].frame(m_frames[0]).positions(),
                                      m_sequences[1].frame(m_frames[1]).positions(), m_weight);
        });
        std::ranges::copy(m_pose, out.begin());
    }

private:
    std::array<MeshSequence, 2> m_sequences;
    std::array<FrameIndex, 2> m_frames;
    double m_weight;
    std::int64_t m_count; ///< frames that it stands for
    mutable std::once_flag m_once;
    mutable std::vector<Vec3f> m_pose;
};

bool isOfMesh(const MeshSequence* sequence, const Topology& topology)
{
    return sequence != nullptr && (sequence->topology.get() == &topology ||
                                   (sequence->topology->vertexCount() == topology.vertexCount() &&
                                    sequence->topology->data().triangles == topology.data().triangles));
}

} // namespace

std::shared_ptr<const FrameSource> betweenPose(const MeshSequence& sequence, const MeshSequence* first,
                                               FrameIndex from, const MeshSequence* second, FrameIndex to,
                                               double weight)
{
    if (!isOfMesh(first, *sequence.topology) || !isOfMesh(second, *sequence.topology))
        return sequence.source;
    return std::make_shared<BetweenPose>(std::array{*first, *second}, std::array{from, to}, weight,
                                         sequence.source->frameCount());
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/document/project.h"
#include "model/project/media/opensequence.h"
#include "model/transfer/pairproposal.h"

#include <functional>
#include <string>
#include <vector>

namespace quadrille {

/// What a transfer is made of, opened: all positions in metres.
class TransferBodies
{
public:
    /// Takes what is worth telling the user.
    using Tell = std::function<void(std::string)>;

    /// \throws Error what opening clip, target and takes throws; ProjectInvalid for frames that they do not
    /// have and for a reference of another mesh; Cancelled.
    TransferBodies(SequenceOpener& opener, TransferEntry entry, const Progress& progress);

    const TransferEntry& entry() const { return m_entry; }
    UpAxis up() const { return m_up; }
    /// The clip, with contacts.
    const MeshSequence& performed() const { return m_takes.front(); }
    /// As the project has it: in its unit.
    const std::shared_ptr<const OpenedSequence>& targetSequence() const { return m_targetSequence; }
    const PosedMesh& target() const { return m_target; }

    /// Those of the entry, whose quality is not known, or proposed ones where it has none: in the entry's
    /// reference pose, or in the one that is most like the target's by pairs that were proposed before.
    /// \throws Error as checkPairs and proposePairs.
    std::vector<ProposedPair> pairs(const Tell& tell, const Progress& progress) const;
    /// The pose of the template that the target's is most like: the entry's, or the best of all takes of the
    /// template, of its mesh as it is in its own file, and of the clip; in steps of some frames first where
    /// these are many.
    PosedMesh referencePose(std::span<const TrianglePair> pairs, const Tell& tell,
                            const Progress& progress) const;
    /// The reference where the entry names one; else where the clip begins.
    PosedMesh anyPose() const;
    TransferSettings settings() const;

private:
    MeshSequence openClip(SequenceOpener& opener, const Progress& progress) const;
    void openTakes(SequenceOpener& opener, const Progress& progress);
    void openMesh(const SequenceOpener& opener, const Progress& progress);
    bool isOfMesh(const MeshSequence& sequence) const;
    /// Some frames of the clip, from the first to the last.
    std::vector<std::vector<Vec3f>> performedPoses() const;
    std::vector<ProposedPair> anyPairs(const Progress& progress) const;
    std::vector<ProposedPair> pairsOfAlikePoses(std::vector<ProposedPair> proposed,
                                                const Progress& progress) const;

    TransferEntry m_entry;
    UpAxis m_up;
    double m_metresPerUnit;
    std::vector<MeshSequence>
        m_takes; ///< the clip, the template's mesh, and the captured ones of it or that of the reference
    std::shared_ptr<const OpenedSequence> m_targetSequence;
    PosedMesh m_target;
};

} // namespace quadrille

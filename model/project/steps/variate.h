// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/media/opensequence.h"
#include "model/project/steps/resultsession.h"
#include "model/transition/characterframes.h"
#include "model/variation/selection.h"

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

// Takes count as an entry of “variations” lists them. \throws Error ProjectInvalid where it names others.

std::vector<MovementBlend> blendsOf(const VariationEntry& entry);
/// What a set of samples varies.
VariationSubject subjectOf(const VariationEntry& entry, const SamplesEntry& samples);

/// What an entry of “variations” is computed from. Takes are opened and aligned at the first use, for all who
/// want the same of the same takes in a session; safe from any thread.
class VariationWork
{
public:
    /// \param opener  of a project that has the entry. \param session  may be null.
    VariationWork(std::shared_ptr<SequenceOpener> opener, VariationEntry entry,
                  std::shared_ptr<ResultSession> session = nullptr);

    const VariationEntry& entry() const { return m_entry; }
    const std::string& character() const { return m_character; }
    const Project& project() const { return m_opener->project(); }
    /// Names of the takes, then of the pre-blends.
    std::vector<std::string> takeNames() const;

    /// The frames of the training takes, as origins of variations count them.
    /// \throws Error what opening the sequences throws.
    FrameLayout layout(const Progress& progress = {});
    /// The training takes, metres, with their contacts. \throws Error as movement.
    const CharacterFrames& frames(const Progress& progress = {});
    /// Takes aligned and cut into parts, in metres.
    /// \throws Error what opening the sequences throws; as cutIntoParts and makeMovement; ProjectInvalid (no
    /// take).
    std::shared_ptr<const Movement> movement(const Progress& progress = {});
    /// The movement with learned models, prepared at the first call; always that one afterwards.
    /// \throws Error as movement.
    std::shared_ptr<const LearnedMovement> learned(std::vector<GpdmState> states,
                                                   const Progress& progress = {});
    /// What judges variations, prepared at the first call.
    /// \throws Error as movement.
    const VariationMeter& meter(const Progress& progress = {});
    /// A clip in metres as one in the project's unit.
    Clip inProjectUnit(Clip clip) const;

    /// The files of the takes, for BuildStep::files.
    std::vector<std::filesystem::path> files(const Progress& progress) const;
    /// All that the movement depends on beside the files, as text.
    std::string movementSettings() const;
    /// The training sequences that are clips of others need these steps.
    std::vector<std::string> clipSteps() const;

    /// What a set of samples varies. \throws Error as subjectOf.
    VariationSubject subject(const SamplesEntry& samples) const { return subjectOf(m_entry, samples); }
    /// How its poses are made, but for the seed; refers to this object. \throws Error as movement.
    VariationPoses poses(const Progress& progress = {}) { return poses(m_entry, progress); }
    /// As another entry says that differs in what is drawn alone.
    VariationPoses poses(const VariationEntry& entry, const Progress& progress);

private:
    /// The takes, and those that poses are taken from.
    std::vector<std::string> sequences() const;
    std::vector<TrainingTake> openTakes(const Progress& progress);
    BodyParts cutParts(const MeshSequence& first, const Progress& progress);

    /// What is made of the takes at the first use, whatever is learned and drawn of them.
    struct Prepared
    {
        std::recursive_mutex mutex;
        std::vector<std::shared_ptr<const OpenedSequence>> sequences; ///< that it is made of
        std::shared_ptr<const Movement> movement;
        std::optional<CharacterFrames> frames; ///< of the takes, metres, with their contacts
        std::optional<VariationMeter> meter;
        std::optional<CapturedStanding> standing;
        std::optional<VariationContacts> contacts;
    };
    /// \throws Error of opening the sequences.
    Prepared& prepared(const Progress& progress);

    std::shared_ptr<SequenceOpener> m_opener;
    VariationEntry m_entry;
    std::shared_ptr<ResultSession> m_session;
    std::string m_character;
    BodyPartsEntry m_parts;
    std::mutex m_mutex; ///< of what follows
    std::shared_ptr<Prepared> m_prepared;
    std::shared_ptr<const LearnedMovement> m_learned;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/feet.h"
#include "model/synthesis/clips/clip.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// Which feet stand in which captured frames of a character.
struct Stances
{
    struct Foot
    {
        std::string name;                    ///< as contacts have it
        std::vector<std::uint32_t> vertices; ///< ascending; all where the mesh has no foot of this name
    };
    static constexpr std::size_t mostFeet = 32;
    std::vector<Foot> feet;
    double height = 0;                   ///< of the figure, metres
    std::vector<std::uint32_t> standing; ///< by node: a bit for each foot

    std::vector<Vec3d> places; ///< of each foot in each node, by node: mean of its vertices

    const Vec3d& placeOf(NodeIndex node, std::size_t foot) const
    {
        return places[static_cast<std::size_t>(node) * feet.size() + foot];
    }
    /// Whether anything is known of feet.
    bool isKnown() const { return !feet.empty(); }
    std::uint32_t at(NodeIndex node) const { return standing[static_cast<std::size_t>(node)]; }
    bool stands(NodeIndex node, std::size_t foot) const { return (at(node) >> foot & 1U) != 0; }
};

/// Of the contacts of each sequence, or those that detectContacts finds where it has none; feet of the mesh
/// by legsOf. \throws Error what reading frames throws, Cancelled. Cost: O(frames · vertices).
Stances findStances(const CharacterFrames& character, UpAxis up, const Progress& progress = {});

/// Of the contacts that the sequences have, without looking at the mesh: its feet have no vertices.
Stances givenStances(const CharacterFrames& character);

/// How long a foot that stands before and after in a transition may be off the ground to count as standing
/// throughout, seconds.
inline constexpr double longestStanceGap = 0.2;

/// How far a blend carries a foot that stands throughout it before it takes a step there
/// (addSteps), heights of the figure: a foot that is held in between has to reach half as far.
inline constexpr double longestCarry = 0.08;

/// How far a foot is carried from one frame of a clip to another, heights of the figure; 0 where nobody knows
/// the foot.
double carriedWay(const Clip& clip, const Stances& stances, std::size_t foot, std::size_t from,
                  std::size_t to);

/// Which feet stand in each frame of a clip, by their bits: those of the frame that counts more in it.
/// Through a transition a foot that stands before and after stands throughout, unless it is off the ground
/// for longer than a fifth of a second or carried farther than longestCarry meanwhile; one that stands on one
/// side only lands or lifts at one moment. Left and right are exchanged where the clip is mirrored.
std::vector<std::uint32_t> stancesBeforeSteps(const Clip& clip, const Stances& stances);
/// The same where feet that a blend carries far take steps (addSteps).
std::vector<std::uint32_t> stancesOf(const Clip& clip, const Stances& stances);

/// In which frames no foot stands for at least 0.06 seconds: shorter ones are steps of which the contact was
/// missed. Empty where no foot ever stands, and nobody knows what stands.
std::vector<bool> framesInAir(const Stances& stances, const FrameLayout& layout, double fps);

/// How fast the feet that stand from one pose to the next slide there: the mean speed over the ground of what
/// touches it, units of length a second; nothing where no foot stands in both.
/// \param feet  that stand in both, by their bits.
std::optional<double> slideOf(Positions before, Positions after, std::uint32_t feet, const Stances& stances,
                              UpAxis up, double fps);

/// The same for each captured frame and the next; nothing at the ends of sequences.
std::vector<std::optional<double>> capturedSlides(const CharacterFrames& character, const Stances& stances,
                                                  UpAxis up, const Progress& progress = {});

/// As contacts of the clip, by their first frames. \param standing  of each of its frames.
std::vector<ContactSpan> contactsOf(std::span<const std::uint32_t> standing, const Stances& stances);
/// The same of stancesOf.
std::vector<ContactSpan> contactsOf(const Clip& clip, const Stances& stances);

} // namespace quadrille

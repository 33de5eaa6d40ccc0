// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/unknownkeys.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// One of the papers' tables, to be computed for the characters of the project.
struct EvaluationEntry
{
    std::string table;     ///< one of evaluationTables
    std::string character; ///< all characters where it is left out
    /// fig11 and fig12: which sequence is blended into which; those that turn most to the left and to the
    /// right where there are none. table2: those that keys are drawn from; all where there are none.
    std::vector<std::string> sequences;
    /// fig9: weights of time; those of the paper where there are none. density: the graph's.
    std::vector<double> alphas;
    /// What is drawn: fig4: pairs of frames, 20; table2: keys, 10; junctions: transitions, 200.
    /// fig17 and fig18: cameras around the body, 4. fig19 and fig20: sets of frames to learn from, of each
    /// size, 5. fig22: pairs of frames, 20; appearance-interpolation: frames at each distance, 20.
    /// appearance-shape: frames of each take whose textures are compared, 10.
    std::optional<std::int64_t> count;
    std::int64_t seed = 1; ///< of what is drawn
    UnknownKeys unknown;

    /// Whether it is of two sequences, of which neither serves without the other.
    bool needsAllSequences() const { return table != "table2"; }
    bool operator==(const EvaluationEntry&) const = default;
};

/// The tables that can be computed, most by their numbers in SMCAS.
inline constexpr std::array<std::string_view, 26> evaluationTables{
    "fig4",       ///< interpolation of poses: how edges and volume are kept
    "fig7",       ///< kinds of transitions
    "fig9",       ///< Essential graph and motion graph
    "fig11",      ///< the centre of a blend with constant weights
    "fig12",      ///< the centre of a blend with weights from 0 to 1
    "table1",     ///< pose distances against reference joint angles
    "table2",     ///< poses at times
    "junctions",  ///< not of the paper: what shows at transitions
    "density",    ///< not of the paper: what makes Essential graphs dense
    "walks",      ///< not of the paper: how calm walks along five paths are, and their feet
    "cvs-fig4",   ///< CVS: poses that models reconstruct, against principal components
    "cvs-fig7",   ///< CVS: blends in latent space, with and without learned ones between
    "variations", ///< not of the paper: what shows of variations, beside the takes that they vary
    "fig17",      ///< SSIM of textures that models of appearance restore, by their number of components
    "fig18",      ///< the same, mean squared error
    "fig19",      ///< SSIM of textures that such models were not learned from, by how many they were
    "fig20",      ///< the same, mean squared error
    "fig22",      ///< textures between two, by the number of Eigen textures
    "appearance-interpolation", ///< not of the paper: textures between two against captured ones
    "appearance-shape",         ///< not of the paper: textures learned from poses, a take left out
    "appearance-rates",         ///< not of the paper: bytes of textures and what they lose
    "transfer-error",           ///< not of the paper: transfers against what they ought to be
    "ia4d-table1",              ///< IA4D: hybrid blends against non-linear ones, by the number of references
    "ia4d-fig4",                ///< the same along the ways from take to take
    "ia4d-table2",              ///< transitions that are found while spaces play, and those computed before
    "ia4d-table3",              ///< interpolated distances of poses against true ones
};

/// Whether a table is of a model of appearance.
inline bool needsAppearance(std::string_view table)
{
    return table.starts_with("appearance-") || table == "fig17" || table == "fig18" || table == "fig19" ||
           table == "fig20" || table == "fig22";
}

/// Whether a table is of transfers that name a truth.
inline bool needsTruth(std::string_view table)
{
    return table == "transfer-error";
}

/// Of how many motion spaces of at least two takes a table is; 0 where it is of none.
inline std::size_t neededMotionSpaces(std::string_view table)
{
    return !table.starts_with("ia4d-") ? 0 : table == "ia4d-table1" || table == "ia4d-fig4" ? 1 : 2;
}

/// Whether a table is of variations.
inline bool needsVariations(std::string_view table)
{
    return table.starts_with("cvs-") || table == "variations";
}

} // namespace quadrille

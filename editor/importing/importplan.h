// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"
#include "model/project/media/importsequences.h"
#include "model/project/media/importsurvey.h"

#include <QString>
#include <vector>

namespace quadrille {

class ProjectDocument;

/// A surveyed take with what the user decided about it.
struct PlannedTake
{
    SurveyedTake take;
    std::string name;
    bool isWanted = true;
    std::optional<FrameRange> range; ///< in source frames; everything when empty
    TextureReference texture;        ///< none: as found beside the take
    TakenRate rate{};                ///< where the file names none
    bool isRateChosen = false;       ///< by the user

    /// Whether it could be opened.
    bool canBeImported() const { return take.sequence.has_value(); }
};

/// What an import is about to add.
struct ImportPlan
{
    std::vector<PlannedTake> takes;
    std::string character;      ///< of the project, or a new one's name
    std::filesystem::path mesh; ///< of a new character
    CoordinateSystem axes;      ///< of the takes whose files name none

    /// Takes that will be added. Good until the plan's takes come or go; so below.
    std::vector<const PlannedTake*> wanted() const;
    /// Whether the rate of a take that moves is a guess that the user did not look at.
    static bool isRateUnknown(const PlannedTake& planned);
    /// Takes that will be added at a rate that is a guess.
    std::vector<const PlannedTake*> withUnknownRate() const;
    /// Gives a rate to a take whose file names none, and to those that had the same one. \param planned  one
    /// of the takes. A take that is sampled from curves is sampled anew, and loses its range.
    void setRate(const PlannedTake& planned, double fps);
    /// How high the figure of a take will stand in the first frame, metres.
    double heightOf(const SurveyedTake& take) const;
};

/// How to survey what a project is to get. \param mesh  that was chosen, or found among it; may be empty.
SurveyOptions surveyOptions(const std::filesystem::path& mesh, const Project& project);

/// The plan that a survey suggests: a name for the character after mesh or folder, a unit that makes it as
/// tall as a person. \param mesh  of the faces, where files have none; empty: that which a take names.
ImportPlan planFor(std::vector<SurveyedTake> takes, const std::filesystem::path& mesh,
                   const Project& project);

/// Adds the wanted takes to the document as one edit; a project without sequences takes their rate.
/// \return the names that they got.
QStringList carryOut(const ImportPlan& plan, ProjectDocument& document);

} // namespace quadrille

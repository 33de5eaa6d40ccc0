// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clip.h"
#include "model/synthesis/clips/ground.h"
#include "model/synthesis/finishing/postprocessingsettings.h"

#include <span>
#include <vector>

namespace quadrille {

/// How a foot is moved in one frame.
struct FootShift
{
    Vec2d pivot = Vec2d::Zero(); ///< the middle of the foot on the ground, about which it turns
    double turn = 0;             ///< radians
    Vec2d shift = Vec2d::Zero();
    double lift = 0; ///< metres

    bool isNothing() const;
    Vec3d operator()(const Vec3d& point, const Ground& ground) const;
};

/// What a foot is, and when it stands.
struct FootContacts
{
    std::vector<std::uint32_t> vertices; ///< of the foot
    std::vector<FrameRange> spans;       ///< in the clip, ascending, apart from each other
};

/// How a foot is moved in each frame so that what touches the ground stands still during its contacts, and
/// is lifted where it steps from one contact to the next inside a blend. \param height  of the figure,
/// metres.
std::vector<FootShift> footShifts(const Clip& clip, const FootContacts& foot,
                                  const ContactCorrectionSettings& settings, double height,
                                  const Ground& ground);

/// Values that are known in some spans of frames, eased to 0 outside them, or from span to span where these
/// are less than two ease times apart; with the pace that the values have at the ends of the spans.
/// \param values  one per frame, replaced outside the spans. \param ease  frames, at least 1.
void easeBetween(std::span<double> values, std::span<const FrameRange> spans, std::int64_t ease);

} // namespace quadrille

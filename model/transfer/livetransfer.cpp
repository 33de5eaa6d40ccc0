// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/livetransfer.h"

namespace quadrille {

LiveTransfer::LiveTransfer(PreparedTransfer prepared, const TransferSettings& settings, double unitsPerMetre)
    : m_prepared(std::move(prepared))
    , m_scale(settings.scale.value_or(m_prepared.sizeRatio()))
    , m_up(settings.up)
    , m_unitsPerMetre(static_cast<float>(unitsPerMetre))
{
}

void LiveTransfer::read(FrameIndex frame, MutablePositions out) const
{
    const auto f = static_cast<std::size_t>(frame.value);
    m_prepared.pose(f, out, m_scratch.local());
    const Vec3d place = placeOf(m_prepared.course(), f, m_scale, m_up, out);
    for (Vec3f& p : out)
        p = (p + place.cast<float>()) * m_unitsPerMetre;
}

} // namespace quadrille

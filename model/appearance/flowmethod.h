// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// How dense optical flow is computed.
enum class FlowMethod
{
    TvL1, ///< Zach, Pock & Bischof 2007, begun where Dis ends
    Dis,  ///< dense inverse search, Kroeger et al. 2016: three times as fast
};

} // namespace quadrille

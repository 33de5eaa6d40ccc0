// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// How dense optical flow is computed.
enum class FlowMethod
{
    TvL1, ///< total variation with an L1 data term (Zach, Pock & Bischof 2007): precise
    Dis,  ///< dense inverse search (Kroeger et al. 2016): quick, for previews
};

} // namespace quadrille

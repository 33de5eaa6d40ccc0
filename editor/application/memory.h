// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// Lets large blocks (clips, tables, pictures) go back to the system as soon as they are freed, and threads
/// share what is kept; otherwise a long session takes more and more. Call once, before any thread is begun.
void keepMemoryTight();

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

/// Marks a sentence, or a part of one, for the translators' tools; the model itself speaks English.
#define QUADRILLE_MESSAGE(text) text

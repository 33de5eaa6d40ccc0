// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/characterlegs.h"

#include "model/sequence/contacts.h"

namespace quadrille {

Legs legsOf(const CharacterFrames& character, UpAxis up, const Progress& progress)
{
    for (const MeshSequence& sequence : character.sequences()) {
        Legs legs = findLegs(*sequence.topology, loadUpright(sequence, up, progress.part(0, 1)),
                             ContactOptions().footShare);
        if (!legs.feet.empty())
            return legs;
    }
    return {};
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/sequences/knownlabels.h"

#include <set>

namespace quadrille {

QStringList knownLabels(const Project& project)
{
    std::set<QString> labels;
    for (const SequenceEntry& sequence : project.sequences) {
        for (const LabelSpan& span : sequence.labels)
            labels.insert(QString::fromStdString(span.label));
    }
    return {labels.begin(), labels.end()};
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/framenames.h"

#include "editor/workspaces/graph/graphexplorer.h"

#include <QLocale>

namespace quadrille {

QString frameName(const GraphExplorer& explorer, NodeIndex frame)
{
    const NamedFrame named = explorer.character()->graph.nameOf(frame);
    //: a sequence and one of its frames
    return GraphExplorer::tr("%1 %2").arg(QString::fromStdString(named.sequence),
                                          QLocale().toString(static_cast<qlonglong>(named.frame.value)));
}

QString pairName(const GraphExplorer& explorer, const FramePair& pair)
{
    //: two frames: a transition from the first to the second
    return GraphExplorer::tr("%1 › %2").arg(frameName(explorer, pair.source),
                                            frameName(explorer, pair.destination));
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

class QMimeData;

namespace quadrille::widgets {

/// What is dragged from one part of the program to another: a take with the frame that its picture shows, or
/// a label.
struct DraggedFrames
{
    QString sequence; ///< empty for a label
    int frame = 0;    ///< of the sequence
    QString label;    ///< empty for a take
    bool operator==(const DraggedFrames&) const = default;
};

/// The kind of data under which they travel.
QString draggedFramesType();

std::unique_ptr<QMimeData> toMimeData(const std::vector<DraggedFrames>& frames);
/// Empty for data of another kind.
std::vector<DraggedFrames> draggedFrames(const QMimeData& data);
/// The takes among them, each once.
QStringList draggedTakes(const QMimeData& data);

} // namespace quadrille::widgets

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/draggedframes.h"

#include <QDataStream>
#include <QIODevice>
#include <QMimeData>

namespace quadrille::widgets {

QString draggedFramesType()
{
    return QStringLiteral("application/x-quadrille-frames");
}

std::unique_ptr<QMimeData> toMimeData(const std::vector<DraggedFrames>& frames)
{
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    for (const DraggedFrames& each : frames)
        stream << each.sequence << each.frame << each.label;
    auto data = std::make_unique<QMimeData>();
    data->setData(draggedFramesType(), bytes);
    return data;
}

std::vector<DraggedFrames> draggedFrames(const QMimeData& data)
{
    std::vector<DraggedFrames> result;
    const QByteArray bytes = data.data(draggedFramesType());
    QDataStream stream(bytes);
    while (!stream.atEnd()) {
        DraggedFrames each;
        stream >> each.sequence >> each.frame >> each.label;
        if (stream.status() != QDataStream::Ok)
            break;
        result.push_back(std::move(each));
    }
    return result;
}

QStringList draggedTakes(const QMimeData& data)
{
    QStringList takes;
    for (const DraggedFrames& frames : draggedFrames(data)) {
        if (!frames.sequence.isEmpty() && !takes.contains(frames.sequence))
            takes += frames.sequence;
    }
    return takes;
}

} // namespace quadrille::widgets

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/sequencemedia.h"

#include <QImage>
#include <QPointer>
#include <QTimer>
#include <map>

namespace quadrille {

class Job;
struct EditorContext;

/// Small pictures of the movement of sequences, to be shown one after the other. Those that are asked for are
/// drawn in jobs, one sequence after the other; what was not asked for longest goes when they take too much
/// memory.
class CardPictures : public QObject
{
    Q_OBJECT

public:
    static constexpr int side = 64;  ///< logical pixels, square
    static constexpr int count = 12; ///< of each sequence, at most
    static constexpr std::size_t usualBytes = std::size_t{64} << 20;

    explicit CardPictures(EditorContext& context, QObject* parent = nullptr);

    /// The pictures of a sequence; none until they are drawn, which asking for them sets going. Those of
    /// before stay until new ones are drawn.
    QList<QImage> pictures(const QString& sequence);
    /// Those that are there, without asking for them.
    qsizetype countOf(const QString& sequence) const;
    /// Draws only while true. \param devicePixelRatio that pictures are drawn for from now on.
    void setActive(bool active, double devicePixelRatio);
    /// How much memory pictures may take; those of the sequence that was asked for last stay in any case.
    void setMostBytes(std::size_t bytes) { m_mostBytes = bytes; }
    /// How much all pictures take now. Cost: O(pictures).
    std::size_t bytes() const;

signals:
    /// The pictures of a sequence are there.
    void drawn(const QString& sequence);

private:
    struct Item
    {
        std::shared_ptr<const FrameSource> source; ///< of what they show
        FrameRange range;
        QList<QImage> images;
        quint64 asked = 0; ///< the greater, the later it was asked for; equal for those asked for together
        bool isDue = true;
    };

    void follow(const ChangeEvent& event);
    void drawNext();
    void draw(const QString& name, const MeshSequence& sequence);
    void forgetOldest();

    EditorContext& m_context;
    std::map<QString, Item> m_items;
    std::size_t m_mostBytes = usualBytes;
    quint64 m_asked = 0;
    QPointer<Job> m_job;
    QTimer m_soon;
    bool m_isActive = false;
    int m_pixels = side;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/sequencemedia.h"

#include <QImage>
#include <QObject>
#include <QPointer>
#include <QTimer>
#include <map>
#include <vector>

namespace quadrille {

class Job;
class JobRunner;

/// Small pictures of single frames of sequences, drawn in jobs when somebody asks for them, and kept.
class FramePictures : public QObject
{
    Q_OBJECT

public:
    static constexpr int side = 64; ///< logical pixels, square

    /// Refers to document, media and jobs. About a thousand pictures are kept, of which all go when there are
    /// more.
    FramePictures(ProjectDocument& document, SequenceMedia& media, JobRunner& jobs,
                  QObject* parent = nullptr);

    /// A picture of a frame; null until it is drawn, or where there is no such frame. Asking for it sets
    /// drawing going; `drawn` tells when to ask again. \param frame  of the sequence as the project has it,
    /// from 0.
    QImage picture(const QString& sequence, FrameIndex frame);

signals:
    /// There are new pictures. Also when there may be others: a sequence was opened, or is another one.
    void drawn();

private:
    using Key = std::pair<QString, std::int64_t>;
    struct Item
    {
        std::shared_ptr<const FrameSource> source; ///< of what the picture shows
        FrameRange range;
        QImage image;
    };

    void draw();

    ProjectDocument& m_document;
    SequenceMedia& m_media;
    JobRunner& m_jobs;
    std::map<Key, Item> m_items;
    std::vector<Key> m_asked;
    QPointer<Job> m_job;
    QTimer m_soon;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/pictures/framepictures.h"

#include "editor/jobs/jobrunner.h"
#include "editor/pictures/pictures.h"
#include "model/core/error.h"
#include "model/render/renderframe.h"
#include "model/render/thumbnail.h"

#include <QGuiApplication>
#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

constexpr std::size_t mostPictures = 1000;
constexpr std::size_t picturesPerJob = 16;

struct Drawing
{
    QString name;
    MeshSequence sequence;
    FrameIndex frame;
    Image picture;
};

std::vector<Drawing> drawAll(std::vector<Drawing> drawings, const RenderOptions& look,
                             const Progress& progress)
{
    const auto count = static_cast<std::int64_t>(drawings.size());
    for (std::int64_t i = 0; i < count; ++i) {
        progress.report(i, count);
        Drawing& each = drawings[static_cast<std::size_t>(i)];
        try {
            const Camera camera = figureCameras(each.sequence, {each.frame}, look).front();
            each.picture = renderFrame(each.sequence, each.frame, camera, look);
        } catch (const Error& error) {
            if (error.code() == ErrorCode::Cancelled)
                throw;
            // It stays without a picture; why is told where the sequence is shown.
        }
    }
    return drawings;
}

} // namespace

FramePictures::FramePictures(ProjectDocument& document, SequenceMedia& media, JobRunner& jobs,
                             QObject* parent)
    : QObject(parent), m_document(document), m_media(media), m_jobs(jobs)
{
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &FramePictures::draw);
    // A sequence that could not be shown may be there now, or be another one.
    connect(&media, &SequenceMedia::changed, this, &FramePictures::drawn);
}

QImage FramePictures::picture(const QString& sequence, FrameIndex frame)
{
    const MeshSequence* resultState = m_media.sequence(sequence);
    if (resultState == nullptr || frame.value < 0 || frame.value >= resultState->frameCount())
        return {};
    const Key key(sequence, frame.value);
    const auto found = m_items.find(key);
    if (found != m_items.end() && found->second.source == resultState->source &&
        found->second.range == resultState->range)
        return found->second.image;
    if (m_items.size() >= mostPictures)
        m_items.clear();
    m_items[key] = {resultState->source, resultState->range, {}};
    m_asked.push_back(key);
    m_soon.start();
    return {};
}

void FramePictures::draw()
{
    if (m_job || m_asked.empty())
        return;
    std::vector<Drawing> drawings;
    for (const Key& key : std::exchange(m_asked, {})) {
        const MeshSequence* sequence = m_media.sequence(key.first);
        if (drawings.size() >= picturesPerJob)
            m_asked.push_back(key);
        else if (sequence != nullptr && key.second < sequence->frameCount())
            drawings.push_back({key.first, *sequence, FrameIndex(key.second), {}});
    }
    const int pixels = qRound(side * qGuiApp->devicePixelRatio());
    const RenderOptions look = thumbnailLook(pixels, pixels, RenderOptions::Background::Transparent,
                                             m_document.project().settings.axes);
    const auto goOn = [this] {
        m_job = nullptr;
        m_soon.start();
    };
    m_job = m_jobs.start(
        {.name = tr("Pictures of frames"),
         .receiver = this,
         .failed =
             [goOn](const Error&) {
                 goOn(); // it was cancelled
             },
         .background = true},
        [drawings = std::move(drawings), look](const Progress& progress) {
            return drawAll(drawings, look, progress);
        },
        [this, goOn](std::vector<Drawing> done) {
            for (Drawing& each : done) {
                const auto found = m_items.find({each.name, each.frame.value});
                if (found != m_items.end() && found->second.source == each.sequence.source)
                    found->second.image = toQImage(std::move(each.picture));
            }
            goOn();
            emit drawn();
        });
}

} // namespace quadrille

#include "moc_framepictures.cpp"

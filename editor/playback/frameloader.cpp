// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/frameloader.h"

#include "editor/pictures/pictures.h"
#include "model/core/mediacache.h"

#include <QThread>
#include <algorithm>

namespace quadrille {

namespace {

/// How many frames are read ahead, at most.
constexpr int lookahead = 12;

std::size_t bytesOf(const LoadedFrame& frame)
{
    std::size_t bytes = frame.positions ? frame.positions->positions().size_bytes() : 0;
    for (const auto& [index, picture] : frame.textures)
        bytes += static_cast<std::size_t>(picture.sizeInBytes());
    return bytes;
}

std::int64_t wrapped(std::int64_t frame, std::int64_t count)
{
    return ((frame % count) + count) % count;
}

} // namespace

LoadedFrame loadFrame(const MeshSequence& sequence, FrameIndex frame)
{
    LoadedFrame loaded{.frame = frame};
    try {
        loaded.positions = sequence.frame(frame);
        const auto materials = std::max<std::size_t>(1, sequence.topology->data().materials.size());
        for (int material = 0; material < static_cast<int>(materials); ++material) {
            const int index = sequence.textures.indexFor(sequence.sourceFrame(frame), material);
            loaded.textures.emplace_back(index, toQImage(sequence.texture(frame, material)));
        }
    } catch (const Error& error) {
        loaded.error = error;
    }
    return loaded;
}

FrameLoader::FrameLoader(QObject* parent, int threads) : QObject(parent)
{
    for (int i = 0; i < threads; ++i)
        m_threads.emplace_back([this] { run(Tasks::All); });
    m_threads.emplace_back([this] { run(Tasks::Wishes); });
}

FrameLoader::~FrameLoader()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stopping = true;
    }
    m_available.notify_all();
    for (std::thread& thread : m_threads)
        thread.join();
}

int FrameLoader::usualThreads()
{
    return std::clamp(QThread::idealThreadCount() - 1, 2, 4);
}

int FrameLoader::addStream(const MeshSequence& sequence)
{
    const std::lock_guard lock(m_mutex);
    m_streams[m_nextStream].sequence = std::make_shared<const MeshSequence>(sequence);
    return m_nextStream++;
}

void FrameLoader::setSequence(int stream, const MeshSequence& sequence)
{
    const std::lock_guard lock(m_mutex);
    Stream& changed = m_streams.at(stream);
    changed.sequence = std::make_shared<const MeshSequence>(sequence);
    changed.wanted.reset();
    changed.aheadLeft = 0;
    changed.frameBytes = 0;
    changed.inWork.clear();
}

void FrameLoader::removeStream(int stream)
{
    const std::lock_guard lock(m_mutex);
    m_streams.erase(stream);
}

void FrameLoader::want(int stream, FrameIndex frame, int step)
{
    {
        const std::lock_guard lock(m_mutex);
        Stream& changed = m_streams.at(stream);
        changed.wanted = frame;
        ++changed.lastWish;
        changed.step = step == 0 ? 1 : step;
        changed.ahead = frame;
        changed.aheadLeft = std::min(step == 0 ? 2 : lookahead, framesThatFit());
    }
    m_available.notify_all();
}

int FrameLoader::framesThatFit() const
{
    std::size_t bytes = 1;
    for (const auto& [id, stream] : m_streams)
        bytes += stream.frameBytes;
    return static_cast<int>(
        std::clamp<std::size_t>(MediaCache::shared()->statistics().budget / 4 * 3 / bytes, 1, lookahead));
}

std::optional<FrameLoader::Task> FrameLoader::takeTask(Tasks tasks)
{
    for (auto& [id, stream] : m_streams) {
        if (stream.wanted) {
            const Task task{id, stream.sequence, *stream.wanted, true, stream.lastWish};
            stream.wanted.reset();
            stream.inWork.push_back(task.frame);
            return task;
        }
    }
    for (auto& [id, stream] : m_streams) {
        while (tasks == Tasks::All && stream.aheadLeft > 0) {
            --stream.aheadLeft;
            stream.ahead =
                FrameIndex(wrapped(stream.ahead.value + stream.step, stream.sequence->frameCount()));
            if (std::ranges::find(stream.inWork, stream.ahead) != stream.inWork.end())
                continue;
            stream.inWork.push_back(stream.ahead);
            return Task{id, stream.sequence, stream.ahead, false, 0};
        }
    }
    return std::nullopt;
}

void FrameLoader::run(Tasks tasks)
{
    std::unique_lock lock(m_mutex);
    while (true) {
        std::optional<Task> task;
        m_available.wait(lock, [&] { return m_stopping || (task = takeTask(tasks)).has_value(); });
        if (m_stopping)
            return;
        lock.unlock();
        const LoadedFrame frame = loadFrame(*task->sequence, task->frame);
        if (task->isWanted)
            deliver(*task, frame);
        lock.lock();
        if (const auto stream = m_streams.find(task->stream);
            stream != m_streams.end() && stream->second.sequence == task->sequence) {
            stream->second.frameBytes = bytesOf(frame);
            stream->second.inWork.erase(std::ranges::find(stream->second.inWork, task->frame));
        }
    }
}

void FrameLoader::deliver(const Task& task, const LoadedFrame& frame)
{
    QMetaObject::invokeMethod(
        this,
        [this, stream = task.stream, sequence = task.sequence, wish = task.wish, frame] {
            {
                const std::lock_guard lock(m_mutex);
                const auto found = m_streams.find(stream);
                if (found == m_streams.end() || found->second.sequence != sequence ||
                    found->second.lastAnswered > wish)
                    return;
                found->second.lastAnswered = wish;
            }
            emit loaded(stream, frame);
        },
        Qt::QueuedConnection);
}

} // namespace quadrille

#include "moc_frameloader.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/sequence/meshsequence.h"

#include <QImage>
#include <QObject>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace quadrille {

/// One frame of a sequence with its textures, ready to be shown.
struct LoadedFrame
{
    FrameIndex frame;
    std::optional<Frame> positions; ///< missing when reading failed
    /// Per material the texture's index in the sequence's TextureSet (−1 for none) and its picture.
    std::vector<std::pair<int, QImage>> textures;
    std::optional<Error> error;
};

/// Reads frames and textures on threads of its own, so that neither the interface nor long jobs hold playback
/// up. Of each stream only the frame wanted last counts; what comes next in the direction of play is read
/// ahead into the media cache. Called from the interface thread, which also gets the signals.
class FrameLoader : public QObject
{
    Q_OBJECT

public:
    /// \param threads  that read ahead, and what is wanted; one more answers wishes alone, so that what is
    /// there already need not wait until one of them is free. All are started here.
    explicit FrameLoader(QObject* parent = nullptr, int threads = usualThreads());
    /// Waits for the frames being read.
    ~FrameLoader() override;

    /// All cores but the one that draws; at least 2, at most 4.
    static int usualThreads();

    /// Makes a stream that shows a sequence. \return its number, from 1; none is used twice.
    int addStream(const MeshSequence& sequence);
    /// Exchanges what a stream shows; what was wanted of the old sequence is not delivered any more. \pre The
    /// stream is there; so for `want`.
    void setSequence(int stream, const MeshSequence& sequence);
    /// Nothing of it is delivered any more.
    void removeStream(int stream);
    /// Up to twelve frames are read ahead, two when standing, as far as three quarters of the media cache
    /// have room.
    /// \param step frames from one to the next while playing, negative backwards, 0 when standing.
    /// \pre 0 ≤ frame < the sequence's frameCount().
    void want(int stream, FrameIndex frame, int step = 0);

signals:
    /// Also where reading failed: then there is an error. Never for an older wish than one that was told of.
    void loaded(int stream, const quadrille::LoadedFrame& frame);

private:
    struct Stream
    {
        std::shared_ptr<const MeshSequence> sequence;
        std::optional<FrameIndex> wanted;
        int step = 0;
        FrameIndex ahead; ///< last frame asked for, from which reading ahead goes on
        int aheadLeft = 0;
        std::vector<FrameIndex> inWork; ///< what threads read now; no other waits for it to read ahead
        std::int64_t lastWish = 0;      ///< wishes are numbered in their order
        std::int64_t lastAnswered = 0;  ///< an answer to an earlier wish comes too late
        std::size_t frameBytes = 0;     ///< of the frame loaded last, with its textures
    };
    struct Task
    {
        int stream = 0;
        std::shared_ptr<const MeshSequence> sequence;
        FrameIndex frame;
        bool isWanted = false;
        std::int64_t wish = 0;
    };

    enum class Tasks
    {
        All,
        Wishes
    };

    void run(Tasks tasks);
    std::optional<Task> takeTask(Tasks tasks);
    /// How many frames of every stream three quarters of the media cache have room for.
    int framesThatFit() const;
    void deliver(const Task& task, const LoadedFrame& frame);

    std::mutex m_mutex;
    std::condition_variable m_available;
    std::map<int, Stream> m_streams;
    int m_nextStream = 1;
    bool m_stopping = false;
    std::vector<std::thread> m_threads;
};

/// Reads one frame and its textures from the cache or their files; never throws. Called from any thread.
LoadedFrame loadFrame(const MeshSequence& sequence, FrameIndex frame);

} // namespace quadrille

Q_DECLARE_METATYPE(quadrille::LoadedFrame)

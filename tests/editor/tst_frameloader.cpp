// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/frameloader.h"
#include "tests/qt/registry.h"

#include <QScopeGuard>
#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <condition_variable>
#include <mutex>

namespace quadrille {

namespace {

/// Twenty frames, of which all but the first two take until they are let go.
class HeldFrames : public FrameSource
{
public:
    std::int64_t frameCount() const override { return 20; }
    std::uint32_t vertexCount() const override { return 3; }
    void read(FrameIndex frame, MutablePositions out) const override
    {
        std::unique_lock lock(m_mutex);
        if (frame.value > 1) {
            ++held;
            m_released.wait(lock, [this] { return m_isReleased; });
        }
        for (Vec3f& position : out)
            position = Vec3f::Constant(static_cast<float>(frame.value));
    }
    void release()
    {
        {
            const std::scoped_lock lock(m_mutex);
            m_isReleased = true;
        }
        m_released.notify_all();
    }

    mutable std::atomic<int> held = 0;

private:
    mutable std::mutex m_mutex;
    mutable std::condition_variable m_released;
    bool m_isReleased = false;
};

std::shared_ptr<const Topology> oneTriangle()
{
    TopologyData data{.vertexCount = 3};
    data.triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)}};
    return std::make_shared<Topology>(std::move(data));
}

std::int64_t frameOf(const QSignalSpy& spy, int signal)
{
    return spy.at(signal).at(1).value<LoadedFrame>().frame.value;
}

} // namespace

class FrameLoaderTest : public QObject
{
    Q_OBJECT

private slots:
    void whatIsThereDoesNotWaitForWhatIsReadAhead();
    void theLatestWishIsAnswered();
};

void FrameLoaderTest::whatIsThereDoesNotWaitForWhatIsReadAhead()
{
    const auto frames = std::make_shared<HeldFrames>();
    FrameLoader loader(nullptr, 2);
    const auto release = qScopeGuard([&] { frames->release(); });
    QSignalSpy loaded(&loader, &FrameLoader::loaded);
    const int stream = loader.addStream(makeSequence("take", oneTriangle(), frames, 25));
    loader.want(stream, FrameIndex(0));
    QTRY_COMPARE(loaded.size(), 1);
    loader.want(stream, FrameIndex(1), 1);
    QTRY_COMPARE(loaded.size(), 2);
    QTRY_COMPARE(frames->held.load(), 2); // both that read ahead
    for (int k = 0; k < 6; ++k) {
        loader.want(stream, FrameIndex(k % 2), 1);
        QTRY_COMPARE(loaded.size(), 3 + k);
        QCOMPARE(frameOf(loaded, 2 + k), k % 2);
    }
}

void FrameLoaderTest::theLatestWishIsAnswered()
{
    const auto frames = std::make_shared<HeldFrames>();
    FrameLoader loader(nullptr, 2);
    const auto release = qScopeGuard([&] { frames->release(); });
    QSignalSpy loaded(&loader, &FrameLoader::loaded);
    const int stream = loader.addStream(makeSequence("take", oneTriangle(), frames, 25));
    for (std::int64_t frame = 2; frame < 9; ++frame)
        loader.want(stream, FrameIndex(frame));
    QTRY_VERIFY(frames->held.load() >= 1);
    frames->release();
    QTRY_VERIFY(!loaded.isEmpty() && frameOf(loaded, static_cast<int>(loaded.size()) - 1) == 8);
    const LoadedFrame last = loaded.last().at(1).value<LoadedFrame>();
    QVERIFY(last.positions.has_value());
    QCOMPARE(last.positions->positions()[0].x(), 8.0F);
    // None comes after a later one.
    for (int k = 1; k < loaded.size(); ++k)
        QVERIFY(frameOf(loaded, k - 1) <= frameOf(loaded, k));
}

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::FrameLoaderTest);
#include "tst_frameloader.moc"

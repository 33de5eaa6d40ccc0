// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/deviceoutput.h"

#include "model/project/store/dataitem.h"

#include <QAudioDevice>
#include <QAudioFormat>
#include <QAudioSink>
#include <QElapsedTimer>
#include <QIODevice>
#include <QMediaDevices>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// What is written ahead to the device.
constexpr qint64 bufferMilliseconds = 80;

/// A sound as a stream of 16 bits, from any time on, with silence around it.
class SoundStream : public QIODevice
{
public:
    SoundStream(std::shared_ptr<const Sound> sound, double gain, double from, int channels)
        : m_sound(std::move(sound))
        , m_factor(std::pow(10, gain / 20))
        , m_frame(std::llround(from * m_sound->rate))
        , m_channels(channels)
    {
        open(QIODevice::ReadOnly);
    }
    bool isSequential() const override { return true; }
    qint64 bytesAvailable() const override
    {
        return qint64{bufferMilliseconds} * m_sound->rate + QIODevice::bytesAvailable();
    }

protected:
    qint64 readData(char* data, qint64 bytes) override
    {
        const auto frameBytes = static_cast<qint64>(sizeof(qint16)) * m_channels;
        auto* out = reinterpret_cast<qint16*>(data);
        for (qint64 left = bytes / frameBytes; left > 0; --left, ++m_frame) {
            for (int channel = 0; channel < m_channels; ++channel)
                *out++ = sample(std::min(channel, m_sound->channels - 1));
        }
        return bytes / frameBytes * frameBytes;
    }
    qint64 writeData(const char*, qint64) override { return -1; }

private:
    qint16 sample(int channel) const
    {
        if (m_frame < 0 || m_frame >= m_sound->frameCount())
            return 0;
        const auto at = static_cast<std::size_t>(m_frame * m_sound->channels + channel);
        return static_cast<qint16>(
            std::lround(std::clamp(m_sound->samples[at] * m_factor, -1.0, 1.0) * 32767));
    }

    std::shared_ptr<const Sound> m_sound;
    double m_factor;
    std::int64_t m_frame;
    int m_channels;
};

class DeviceOutput : public SoundOutput
{
public:
    void start(std::shared_ptr<const Sound> sound, double gain, double from) override
    {
        stop();
        m_from = from;
        m_time.start();
        const QAudioDevice device = QMediaDevices::defaultAudioOutput();
        QAudioFormat format;
        format.setSampleRate(sound->rate);
        format.setChannelCount(std::min(sound->channels, 2));
        format.setSampleFormat(QAudioFormat::Int16);
        if (device.isNull() || !device.isFormatSupported(format))
            return;
        m_stream = std::make_unique<SoundStream>(std::move(sound), gain, from, format.channelCount());
        m_sink = std::make_unique<QAudioSink>(device, format);
        m_sink->setBufferSize(format.bytesForDuration(qint64{bufferMilliseconds} * 1000));
        m_sink->start(m_stream.get());
    }

    void stop() override
    {
        if (m_sink)
            m_sink->stop();
        m_sink.reset();
        m_stream.reset();
    }

    double heard() const override
    {
        // Without a device time goes on, so that nobody tries again for every frame.
        const double played = m_sink ? static_cast<double>(m_sink->processedUSecs()) * 1e-6
                                     : static_cast<double>(m_time.nsecsElapsed()) * 1e-9;
        return m_from + played;
    }

private:
    double m_from = 0;
    QElapsedTimer m_time;
    std::unique_ptr<SoundStream> m_stream;
    std::unique_ptr<QAudioSink> m_sink;
};

} // namespace

std::unique_ptr<SoundOutput> makeDeviceOutput()
{
    return std::make_unique<DeviceOutput>();
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/results/openanimation.h"
#include "model/synthesis/quality/junctionquality.h"

#include <QObject>
#include <QPointer>
#include <optional>

namespace quadrille {

class Job;
class JobRunner;

/// Measures how much a transition shows, in a job. What it needs of a character is measured once. Of several
/// transitions that are asked for quickly, only the last is measured.
class JunctionInspector : public QObject
{
    Q_OBJECT

public:
    explicit JunctionInspector(JobRunner& jobs, QObject* parent = nullptr);
    ~JunctionInspector() override;

    /// Nothing is measured for a character whose feet are not known.
    /// \param entry  how transitions are blended. \pre There is a transition between the frames.
    void inspect(const std::shared_ptr<const OpenedCharacter>& character, const FramePair& transition,
                 const AnimationEntry& entry);
    /// Forgets what was asked for and measured.
    void clear();
    /// Of the transition that was asked for last; nothing until they are there.
    const std::optional<JunctionMeasures>& measures() const { return m_measures; }

signals:
    /// There are measures, or none any more.
    void changed();

private:
    using FrameMeasures = std::vector<FrameMeasure>;
    struct Request
    {
        std::shared_ptr<const OpenedCharacter> character;
        FramePair transition;
        bool isGentle = false;
        InterpolationMethod interpolation = InterpolationMethod::Poisson;
        bool operator==(const Request&) const = default;
    };
    struct Inspected
    {
        std::shared_ptr<const FrameMeasures> frames;
        JunctionMeasures measures;
    };
    static Inspected measure(const Request& asked, std::shared_ptr<const FrameMeasures> frames,
                             const Progress& progress);

    JobRunner& m_jobs;
    QPointer<Job> m_job;
    std::optional<Request> m_asked;
    std::optional<JunctionMeasures> m_measures;
    std::shared_ptr<const OpenedCharacter> m_character; ///< that the measures of frames are of
    std::shared_ptr<const FrameMeasures> m_frames;
};

} // namespace quadrille

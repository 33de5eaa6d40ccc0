// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/jobs/job.h"
#include "model/project/results/opencharacter.h"

#include <QObject>
#include <QPointer>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille {

class JobRunner;

/// How fast feet slide in transitions and how far their ends differ in speed: measured in jobs, one
/// transition after the other, and kept.
class TransitionSpeeds : public QObject
{
    Q_OBJECT

public:
    /// As footSlide and speedJump have them, in metres a second; nothing where there is nothing to measure.
    struct Speeds
    {
        std::optional<double> slide;
        std::optional<double> jump;
    };

    explicit TransitionSpeeds(JobRunner& jobs, QObject* parent = nullptr);

    /// Forgets all that was measured.
    void setCharacter(std::shared_ptr<const OpenedCharacter> opened);
    /// Takes one with the same frames instead; what was measured stays.
    void replaceCharacter(std::shared_ptr<const OpenedCharacter> opened) { m_opened = std::move(opened); }
    /// How transitions are blended, see PairPreview::setGentle.
    void setGentle(bool gentle);
    /// Measures these in their order, instead of others that were asked for before. \pre there is a
    /// transition between the frames of each.
    void ask(std::vector<FramePair> pairs);
    /// Null until it is measured. A transition that could not be blended has neither. Good until `changed`.
    const Speeds* of(const FramePair& pair) const;

signals:
    /// One more is measured, or none is known any more.
    void changed();

private:
    void forget();
    void measureNext();

    JobRunner& m_jobs;
    std::shared_ptr<const OpenedCharacter> m_opened;
    bool m_isGentle = false;
    int m_generation = 0; ///< of what is measured: results of earlier ones are dropped
    std::vector<FramePair> m_asked;
    std::map<std::pair<NodeIndex, NodeIndex>, Speeds> m_known;
    QPointer<Job> m_job;
};

} // namespace quadrille

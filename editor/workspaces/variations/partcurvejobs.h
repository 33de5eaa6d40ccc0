// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/jobs/job.h"
#include "editor/workspaces/variations/partcurvework.h"

#include <QObject>
#include <QPointer>

namespace quadrille {

class JobRunner;

/// Computes curves in jobs, one at a time, on copies of the body. What comes of a job is told, unless the
/// body or its surface is another by then. While one works, and without a surface, nothing else is begun.
class PartCurveJobs : public QObject
{
    Q_OBJECT

public:
    /// \param content  outlives it, as does `runner`.
    PartCurveJobs(const PartCurveContent& content, JobRunner& runner, QObject* parent = nullptr);

    bool isBusy() const { return m_job != nullptr; }
    /// \param topology  of the surface. \param up  of the project.
    void propose(const std::shared_ptr<const Topology>& topology, UpAxis up);
    void addPart(const NewPart& part);
    /// To the selected curve.
    void addSecondCurve();
    /// The selected curve or part.
    void mirror();
    /// The selected curve.
    void shorten();
    /// The surface is another now.
    void forgetSurface() { m_symmetry.reset(); }

signals:
    /// A job was begun: what was told of the last one is out of date.
    void begun();
    void busyChanged();
    void failed(const quadrille::Error& error);
    /// \param text  what the history calls it. \param selection  what is to be selected; none: as it was.
    void computed(const QString& text, const quadrille::BodyPartsEntry& body,
                  const quadrille::PartSelection& selection);

private:
    using Work = std::function<BodyPartsEntry(BodyPartsEntry, const Progress&)>;
    void run(const QString& name, const QString& text, Work work, const PartSelection& selection = {});

    const PartCurveContent& m_content;
    JobRunner& m_runner;
    QPointer<Job> m_job;
    std::shared_ptr<const Symmetry> m_symmetry; ///< of the surface, once it was asked for
};

} // namespace quadrille

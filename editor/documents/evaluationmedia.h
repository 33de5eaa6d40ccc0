// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"
#include "model/core/error.h"
#include "model/project/results/openevaluations.h"
#include "model/project/store/dataitem.h"

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <map>
#include <optional>

namespace quadrille {

class Job;
class JobRunner;

/// The tables of a document's evaluations. What is up to date among the results is opened by itself, again
/// whenever the project changes; the rest is computed on demand.
class EvaluationMedia : public QObject
{
    Q_OBJECT

public:
    enum class State
    {
        Opening,    ///< nobody knows yet whether it is up to date
        Impossible, ///< there is nothing that it could be about
        Stale,
        Computing,
        Fresh,
        Failed,
    };
    struct ResultState
    {
        State state = State::Opening;
        std::vector<DataItem> tables; ///< the last ones; of other inputs unless fresh, none at first
        std::optional<Error> error;   ///< there when failed
        QPointer<Job> job;            ///< there when computing
    };

    EvaluationMedia(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    ~EvaluationMedia() override;

    /// Null when the project has no such evaluation. \param name  see evaluationName().
    const ResultState* resultState(const QString& name) const;
    /// Computes it and what it needs, as a rebuild does. Nothing happens while it is being computed.
    void compute(const QString& name);
    void stop(const QString& name);

signals:
    /// The state or the tables of an evaluation are others now, or it has come or gone.
    void changed(const QString& name);

private:
    void follow(const ChangeEvent& event);
    void update();
    void open();
    void take(const QStringList& names, std::vector<OpenedEvaluation> opened);
    void take(const QString& name, OpenedEvaluation opened);
    void connectEnd(const QString& name, Job* job);

    ProjectDocument& m_document;
    JobRunner& m_jobs;
    QTimer m_delay; ///< edits follow each other quickly
    QPointer<Job> m_opening;
    std::map<QString, ResultState> m_media;
};

} // namespace quadrille

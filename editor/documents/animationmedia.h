// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/graphmedia.h"
#include "model/project/document/findentry.h"
#include "model/project/document/project.h"

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>

namespace quadrille {

struct AnimationResult;

/// The animations of a document as clips that can be shown. Those that are wanted are solved in jobs by
/// themselves, and again whenever they or their graph change; each better walk is told as soon as it is
/// found, and the last result stays until then.
class AnimationMedia : public QObject
{
    Q_OBJECT

public:
    enum class State
    {
        Idle,    ///< not wanted, nothing is asked of it yet, or stopped by the user
        Waiting, ///< for the graph of its character
        Solving,
        Ready,
        Failed,
    };
    struct ResultState
    {
        State state = State::Idle;
        std::shared_ptr<const AnimationResult> result; ///< the last one; may be null, may be outdated
        std::optional<Error> error;                    ///< there when failed
        QPointer<Job> job;                             ///< there when solving
    };

    AnimationMedia(ProjectDocument& document, GraphMedia& graphs, JobRunner& jobs, QObject* parent = nullptr);
    ~AnimationMedia() override;

    /// The animations that somebody looks at: these are solved.
    void want(const QStringList& names);
    /// Null when the project has no such animation, or nobody ever wanted it.
    const ResultState* resultState(const QString& name) const;
    /// The last result of an animation; null without one.
    std::shared_ptr<const AnimationResult> result(const QString& name) const;
    /// The character that an animation is of; empty in a project without characters.
    QString characterOf(const QString& name) const;
    /// Seeks again what failed or was stopped.
    void retry(const QString& name);
    /// Ends the search; the best walk so far stays.
    void stop(const QString& name);

signals:
    /// The state or the result of an animation is another now.
    void changed(const QString& name);

private:
    struct Mailbox;
    struct Item
    {
        ResultState resultState;
        AnimationEntry solved; ///< what the last search was started with
        Project drawnFrom;     ///< and its variations
        std::shared_ptr<const OpenedCharacter> character;
        int search = 0; ///< counts searches, so that late results are known
        bool isStopped = false;
    };

    void follow(const ChangeEvent& event);
    void rename(const ChangeEvent& event);
    void update();
    void update(const QString& name, Item& item);
    void solve(const QString& name, Item& item, const AnimationEntry& entry);
    void take(const QString& name, int search, std::shared_ptr<const AnimationResult> result);
    void setIdle(const QString& name, Item& item);

    ProjectDocument& m_document;
    GraphMedia& m_graphs;
    JobRunner& m_jobs;
    std::shared_ptr<Mailbox> m_mailbox;
    QTimer m_delay; ///< edits follow each other quickly
    QStringList m_wanted;
    std::map<QString, Item> m_items;
    int m_searches = 0;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"
#include "editor/documents/variationresult.h"

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>

namespace quadrille {

class Job;
class JobRunner;
struct LearnedVariation;
struct Movement;
struct VariationBasis;
struct VariationJob;

/// The variations of a document. The takes of those that are wanted are aligned by themselves, and what was
/// learned or drawn before is read; models are learned when somebody asks; variations are drawn by
/// themselves, and again whenever what they depend on changes. Results stay a while when nobody wants them.
class VariationMedia : public QObject
{
    Q_OBJECT

public:
    enum class State
    {
        Idle,    ///< not wanted, or there are no takes to learn from
        Opening, ///< takes are aligned, what was learned is read
        NotLearned,
        Learning,
        Drawing,
        Ready,
        Failed,
    };
    struct ResultState
    {
        State state = State::Idle;
        std::shared_ptr<const Movement> movement; ///< may be null
        std::vector<PartProgress> parts;          ///< of the movement; empty before learning
        bool isStopped = false;                   ///< `parts` are the best before learning was stopped
        std::shared_ptr<const std::vector<DrawnSet>> drawn; ///< of each of the entry's samples; may be null
        std::optional<Error> error;                         ///< there when failed
        QPointer<Job> job;                                  ///< there while there is work
    };

    VariationMedia(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    ~VariationMedia() override;

    /// The variations that somebody looks at.
    void want(const QStringList& names);
    /// Null where the project has none of this name, or nobody wanted them lately.
    const ResultState* resultState(const QString& name) const;
    /// A variation by its number among all of an entry's, from 1; null until it is drawn.
    const MeshSequence* clip(const QString& name, int number) const;
    /// Learns the models of all parts, anew where they are there.
    void learn(const QString& name);
    /// Ends learning; the best so far stays.
    void stop(const QString& name);
    /// Tries again what failed.
    void retry(const QString& name);
    /// Others may have learned to the end what was stopped here: it is taken from beside the project.
    void readStopped();

signals:
    /// The state or the result of variations is another now.
    void changed(const QString& name);

private:
    struct Mailbox;
    struct Item;

    void rename(const ChangeEvent& event);
    void follow(const ChangeEvent& event);
    void update();
    void update(const QString& name, Item& item);
    /// Null where the item is gone or does something else by now.
    Item* itemOf(const QString& name, int run);
    VariationJob jobOf(const QString& name) const;
    void end(Item& item);
    template <typename Work, typename Done>
    void start(const QString& text, const QString& name, Item& item, Work work, Done done);
    void open(const QString& name, Item& item, const VariationBasis& basis);
    void draw(const QString& name, Item& item);
    void takeLearned(const QString& name, int run, std::shared_ptr<const LearnedVariation> learned);

    ProjectDocument& m_document;
    JobRunner& m_jobs;
    std::shared_ptr<Mailbox> m_mailbox;
    QTimer m_delay; ///< edits follow each other quickly
    QStringList m_wanted;
    std::map<QString, std::unique_ptr<Item>> m_items;
    int m_runs = 0;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/variationresult.h"
#include "editor/documents/wantedresults.h"

namespace quadrille {

struct LearnedVariation;
struct Movement;
struct VariationBasis;
struct VariationJob;

/// The variations of a document. The takes of those that are wanted are aligned by themselves, and what was
/// learned or drawn before is read; models are learned when somebody asks; variations are drawn by
/// themselves, and again whenever what they depend on changes. Results stay a while when nobody wants them.
class VariationResults : public WantedResults
{
    Q_OBJECT

public:
    /// What its job does.
    enum class Work
    {
        Opening, ///< takes are aligned, what was learned is read
        Learning,
        Drawing,
    };
    /// Idle where it is not wanted, there are no takes to learn from, or it is not learned.
    struct State : ResultState
    {
        Work work = Work::Opening;                ///< while computing
        std::shared_ptr<const Movement> movement; ///< may be null
        std::vector<PartProgress> parts;          ///< of the movement; empty before learning
        bool isStopped = false;                   ///< `parts` are the best before learning was stopped
        std::shared_ptr<const std::vector<DrawnSet>> drawn; ///< of each of the entry's samples; may be null

        bool does(Work what) const { return phase == ResultPhase::Computing && work == what; }
        /// Its takes are aligned, and somebody has to ask for its models.
        bool isNotLearned() const { return phase == ResultPhase::Idle && movement != nullptr; }
    };

    VariationResults(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    ~VariationResults() override;

    /// The variations that somebody looks at. Of those that nobody wants any more the last three are kept;
    /// work on them ends, but for learning.
    void want(const QStringList& names) { setWanted(names); }
    /// Null where the project has none of this name, or nobody wanted them lately.
    const State* resultState(const QString& name) const { return find<const State>(name); }
    /// A variation by its number among all of an entry's, from 1; null until it is drawn. Also null where it
    /// could not be drawn. Good until `changed` tells the name.
    const MeshSequence* clip(const QString& name, int number) const;
    /// Learns the models of all parts, anew where they are there. Where its takes are not aligned for an
    /// error, they are tried again; nothing else happens while they are being aligned, or nobody wants it.
    /// Parts become known to `changed` several times a second while it lasts.
    void learn(const QString& name);
    /// Ends learning; the best so far stays, and comes soon. Also ends aligning and drawing, without a
    /// result.
    void stop(const QString& name) override;
    /// Tries again what failed.
    void retry(const QString& name);
    /// Others may have learned to the end what was stopped here: it is taken from beside the project.
    void readStopped();
    /// Opens again what is open: the takes have other textures. What is being learned goes on.
    void reopen();

private:
    struct Item;

    void follow(const ChangeEvent& event) override;
    void renamed(const QString& before, const QString& name) override;
    void update() override;
    void stopped(const QString& name, ResultState& state) override;
    void update(const QString& name, Item& item);
    void forgetUnwanted();
    void rest(Item& item);
    VariationJob jobOf(const QString& name) const;
    void open(const QString& name, Item& item, const VariationBasis& basis);
    void draw(const QString& name, Item& item);
    void takeLearned(const QString& name, Item& item, std::shared_ptr<const LearnedVariation> learned);

    int m_looks = 0; ///< counts when variations were wanted
};

} // namespace quadrille

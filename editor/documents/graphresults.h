// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/wantedresults.h"

namespace quadrille {

struct CostOverview;
struct OpenedCharacter;

/// The graphs of a document's characters: opened where the results are there, computed when somebody asks.
/// From then on they follow the project; the last one stays while another is on its way.
class GraphResults : public WantedResults
{
    Q_OBJECT

public:
    /// Idle where nobody asked for it yet.
    struct State : ResultState
    {
        /// The last one that was opened, when ready that of the project as it is; may be null.
        std::shared_ptr<const OpenedCharacter> opened;
        /// What is known of its costs while it is opened for the first time; null before and after.
        std::shared_ptr<const CostOverview> overview;
    };

    GraphResults(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    ~GraphResults() override;

    /// Null where no sequence has this character. A project without characters has one called "".
    const State* resultState(const QString& character) const { return find<const State>(character); }
    /// The characters that have sequences, in project order.
    QStringList characters() const;
    /// The character that a graph is of when nobody chooses: the first; empty without any.
    QString firstCharacter() const;
    /// Computes the graph of a character where it is missing or failed, and keeps it up to date. It is, until
    /// the user stops such a job. Nothing happens for a character without sequences.
    void ask(const QString& character);
    /// Opens again what is open: the takes of a graph have other textures.
    void reopen();

private:
    /// All of a project that a graph depends on.
    struct Source
    {
        GraphEntry graph;
        ProjectSettings settings;
        std::vector<CharacterEntry> characters;
        std::vector<SequenceEntry> sequences;
        /// Where a sequence shows a clip that is made.
        std::vector<AnimationEntry> animations;
        std::vector<BodyPartsEntry> bodyParts;
        std::vector<VariationEntry> variations;
        bool operator==(const Source&) const = default;
    };
    struct Item : State
    {
        std::optional<Source> source; ///< of the last work
        bool isWanted = false;        ///< to be computed; otherwise only opened where the results are there
    };

    void follow(const ChangeEvent& event) override;
    void update() override;
    void stopped(const QString& character, ResultState& state) override;
    void open(const QString& character, Item& item);
    Source sourceOf(const QString& character) const;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>

namespace quadrille {

class Job;
class JobRunner;
struct OpenedCharacter;

/// The graphs of a document's characters: opened where the results are there, computed when somebody asks.
/// From then on they follow the project; the last one stays while another is on its way.
class GraphMedia : public QObject
{
    Q_OBJECT

public:
    enum class State
    {
        Missing,   ///< nobody asked for it yet
        Computing, ///< being opened or computed
        Ready,     ///< as the project says
        Failed,
    };
    struct ResultState
    {
        State state = State::Missing;
        /// The last one that was opened, when ready that of the project as it is; may be null.
        std::shared_ptr<const OpenedCharacter> opened;
        std::optional<Error> error; ///< there when failed
        QPointer<Job> job;          ///< there when computing
    };

    GraphMedia(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    ~GraphMedia() override;

    /// Null where no sequence has this character. A project without characters has one called "".
    const ResultState* resultState(const QString& character) const;
    /// The characters that have sequences, in project order.
    QStringList characters() const;
    /// The character that a graph is of when nobody chooses: the first; empty without any.
    QString firstCharacter() const;
    /// Computes the graph of a character where it is missing or failed, and keeps it up to date.
    void ask(const QString& character);
    /// Stops computing; what was there before stays.
    void cancel(const QString& character);

signals:
    /// The graph of a character has another state or content.
    void changed(const QString& character);

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
    struct Item
    {
        Source source;
        ResultState resultState;
        bool isWanted = false; ///< to be computed; otherwise only opened where the results are there
    };

    void follow(const ChangeEvent& event);
    void update();
    void open(const QString& character, Item& item);
    void forget(const QString& character, Item& item);
    Source sourceOf(const QString& character) const;

    ProjectDocument& m_document;
    JobRunner& m_jobs;
    QTimer m_delay; ///< edits follow each other quickly
    std::map<QString, Item> m_items;
};

} // namespace quadrille

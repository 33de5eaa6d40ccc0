// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/wantedresults.h"
#include "model/project/media/opensequence.h"
#include "model/sequence/meshsequence.h"

namespace quadrille {

/// The sequences of a document as meshes that can be shown: opened in jobs as soon as the project names them,
/// and opened again when their source changes. Clips of
/// animations are read from the project's results. Trimming and marking does not open anything.
class SequenceMedia : public WantedResults
{
    Q_OBJECT

public:
    /// Computing while it is opened.
    struct State : ResultState
    {
        /// All frames of the source, at its own rate; there when ready, and when only the range failed.
        std::optional<MeshSequence> whole;
        /// All frames of the source at the project's rate, as it is shown for trimming.
        std::optional<MeshSequence> untrimmed;
        /// What the project makes of it: cut to its range, with labels and contacts. There when ready.
        std::optional<MeshSequence> sequence;
        std::vector<Issue> issues;
    };

    SequenceMedia(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    ~SequenceMedia() override;

    /// Null when the project has no such sequence.
    const State* resultState(const QString& name) const { return find<const State>(name); }
    /// The sequence when it is ready, else null. Good until `changed` tells its name.
    const MeshSequence* sequence(const QString& name) const;
    /// The sequence with all frames of its source, at the project's rate, else null.
    const MeshSequence* untrimmed(const QString& name) const;
    /// The frames of the untrimmed sequence that the project uses. Empty while it is not open.
    FrameRange usedFrames(const QString& name) const;
    /// The range in source frames that stands for frames of the untrimmed sequence; empty for all of them.
    /// Ends are rounded to the nearest frame of the source. Also empty while it is not open.
    std::optional<FrameRange> sourceRange(const QString& name, FrameRange used) const;
    /// Opens a sequence again that failed or was stopped. Nothing happens where it did not.
    void retry(const QString& name);
    /// Opens those sequences again that show clips of animations which were computed meanwhile.
    void refresh() { updateNow(); }
    /// Whether any of them is being opened.
    bool isLoading() const;
    UpAxis upAxis() const { return document().project().settings.axes.up; }

private:
    /// What decides which frames a sequence has.
    struct Source
    {
        SequenceEntry entry; ///< without name, range, labels, contacts
        CharacterEntry character;
        ProjectSettings settings;
        std::optional<Project> parts; ///< that it is a clip of
        std::filesystem::path results;
        std::filesystem::path folder; ///< that names of files in results are relative to
        /// When clips that it shows, and the models of their textures, were computed; the least time for
        /// those that were not.
        std::vector<std::filesystem::file_time_type> computed;
        bool operator==(const Source&) const = default;
    };
    struct Item : State
    {
        std::optional<Source> source;
        SequenceEntry entry;
        /// Held, so that nobody opens the source again.
        std::shared_ptr<const OpenedSequence> opened;
    };

    void follow(const ChangeEvent& event) override;
    void update() override;
    /// It is not there: that is an error to those who look.
    void stopped(const QString& name, ResultState& state) override;
    static std::shared_ptr<const OpenedSequence>
    openWhole(const Source& source, const std::shared_ptr<SourceCache>& sources, const Progress& progress);
    void open(const QString& name, Item& item);
    static void shape(Item& item);
    Source sourceOf(const SequenceEntry& entry) const;
};

} // namespace quadrille

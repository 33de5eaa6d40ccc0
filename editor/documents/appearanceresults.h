// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/appearancework.h"
#include "editor/documents/wantedresults.h"

#include <QHash>

namespace quadrille {

/// The models of appearance of a document. Of those that somebody looks at, the last one computed is read,
/// again whenever the project changes; others are computed on demand only, since that takes minutes.
class AppearanceResults : public WantedResults
{
    Q_OBJECT

public:
    enum class Work
    {
        Looking,
        Building,
        Completing,
    };
    /// Idle while nobody knows yet whether it is up to date.
    struct State : ResultState
    {
        OpenedAppearancePointer opened; ///< the last one; null before it was looked for
        Work work = Work::Looking;      ///< while computing

        bool does(Work what) const { return phase == ResultPhase::Computing && work == what; }
        bool hasModel() const { return opened != nullptr && opened->decoder != nullptr; }
    };

    AppearanceResults(ProjectDocument& document, JobRunner& jobs, QObject* parent = nullptr);
    ~AppearanceResults() override;

    /// The models that somebody looks at. Others are let go of, unless they are being computed.
    void want(const QStringList& names) { setWanted(names); }
    /// Null where the project has no such model, or nobody ever wanted it.
    const State* resultState(const QString& name) const { return find<const State>(name); }
    /// Computes the model where it is not up to date. Nothing happens where nobody wants it, or while it is
    /// being computed.
    void build(const QString& name);
    /// Computes the textures that it completes, and the model before where that is not up to date. Nothing
    /// happens without any; else as `build`.
    void complete(const QString& name);

signals:
    /// A model was computed, textures were completed, or variations take them from elsewhere: clips that were
    /// opened before have others.
    void texturesMade(const QString& name);

private:
    struct Item : State
    {
        std::optional<Project> looked; ///< all that the last look depended on
    };

    void follow(const ChangeEvent& event) override;
    void renamed(const QString& before, const QString& name) override;
    void update() override;
    void stopped(const QString& name, ResultState& state) override;
    void look(const QString& name, Item& item);
    void compute(const QString& name, Work work);
    static void take(Item& item, OpenedAppearancePointer opened);
    AppearanceJob jobOf(const QString& name, const Item& item) const;
    Project basisOf(const QString& name) const;
    void followVaried(bool tells);

    QHash<QString, VariedTextures> m_varied; ///< what the project says of its models
};

} // namespace quadrille

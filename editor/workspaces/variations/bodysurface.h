// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/jobs/job.h"
#include "model/core/error.h"
#include "model/geometry/surfacegraph.h"
#include "model/project/document/variationentry.h"

#include <QObject>
#include <QPointer>
#include <memory>
#include <optional>

namespace quadrille {

class CurrentVariation;
struct MeshSequence;

/// The surface of the character's body in the pose that curves are drawn in, read off the interface thread.
class BodySurface : public QObject
{
    Q_OBJECT

public:
    explicit BodySurface(CurrentVariation& variation, QObject* parent = nullptr);

    /// In metres. Null until it is there.
    std::shared_ptr<const SurfaceGraph> graph() const { return m_graph; }
    /// Which pose that is; none without sequences.
    std::optional<NamedFrame> pose() const;
    bool isLoading() const { return m_job != nullptr; }
    /// Why there is no surface; none while there is one, or nothing to read.
    const std::optional<Error>& error() const { return m_error; }

signals:
    /// There is another surface, none any more, an error, or one is being read.
    void changed();

private:
    /// What the surface is read from.
    struct Source
    {
        std::shared_ptr<const void> topology;
        std::shared_ptr<const void> frames;
        FrameIndex frame{0};
        double metresPerUnit = 1;
        bool operator==(const Source&) const = default;
    };
    void update();
    void read(const MeshSequence& sequence, FrameIndex frame);

    CurrentVariation& m_variation;
    Source m_source;
    std::shared_ptr<const SurfaceGraph> m_graph;
    std::optional<Error> m_error;
    QPointer<Job> m_job;
};

} // namespace quadrille

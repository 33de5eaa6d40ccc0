// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/latent/latentpath.h"
#include "widgets/theme/colormap.h"

#include <QPointer>
#include <QWidget>

class QComboBox;
class QToolButton;

namespace quadrille {

class CurrentVariation;
class Job;
struct PartProgress;

namespace widgets {
class LatentView;
} // namespace widgets

/// The latent space of one part: a trajectory for each take and for each variation that is shown, with the
/// frame of now, and how sure the model is.
class LatentPanel : public QWidget
{
    Q_OBJECT

public:
    /// Registers the action.
    explicit LatentPanel(CurrentVariation& variation, QWidget* parent = nullptr);

    widgets::LatentView& view() { return *m_view; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void refresh();
    void refreshParts();
    void followPlayer();
    void askForConfidence();
    const PartProgress* part() const;
    std::vector<widgets::LatentPath> paths(const PartProgress& part) const;

    CurrentVariation& m_variation;
    QComboBox* m_part;
    QToolButton* m_confidence;
    widgets::LatentView* m_view;
    QPointer<Job> m_job;
    int m_asked = 0; ///< counts jobs, so that late results are known
};

} // namespace quadrille

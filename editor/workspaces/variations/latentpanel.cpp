// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/latentpanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/actionbutton.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/latentconfidence.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/variation/movement.h"
#include "widgets/latent/latentview.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace quadrille {

namespace {

using widgets::LatentPath;

/// Variations have the colours before.
constexpr int firstTakeColor = 7;

QVector3D placeOf(const RowMatrix& latents, Eigen::Index row)
{
    QVector3D place;
    for (Eigen::Index axis = 0; axis < std::min<Eigen::Index>(latents.cols(), 3); ++axis)
        place[static_cast<int>(axis)] = static_cast<float>(latents(row, axis));
    return place;
}

std::vector<QVector3D> placesOf(const RowMatrix& latents, Eigen::Index first, Eigen::Index count)
{
    std::vector<QVector3D> places;
    for (Eigen::Index row = first; row < first + count; ++row)
        places.push_back(placeOf(latents, row));
    return places;
}

} // namespace

LatentPanel::LatentPanel(CurrentVariation& variation, QWidget* parent)
    : QWidget(parent)
    , m_variation(variation)
    , m_part(new QComboBox)
    , m_confidence(nullptr)
    , m_view(new widgets::LatentView)
{
    setObjectName(QStringLiteral("latentPanel"));
    m_part->setObjectName(QStringLiteral("latentPart"));
    m_part->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    QAction* confidence = variation.context().actions.addToggle(
        {"variations.confidence",
         [] { return tr("Variations"); },
         [] { return tr("&Confidence in the latent space"); },
         [] { return tr("Colours tell how sure the model is, instead of which take a line is"); },
         "scalar",
         {}},
        false, [this](bool shown) {
            m_view->setConfidenceShown(shown);
            askForConfidence();
        });
    m_confidence = makeActionButton(confidence);
    QAction* whole = variation.context().actions.add(
        {"variations.frameLatent",
         [] { return tr("Variations"); },
         [] { return tr("Show the whole laten&t space"); },
         [] { return tr("Brings all lines into the view; in the view itself, F does so"); },
         "frameall",
         {}},
        [this] { m_view->frameAll(); });
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(4);
    row->addWidget(m_part);
    row->addStretch(1);
    row->addWidget(m_confidence);
    row->addWidget(makeActionButton(whole));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(row);
    column->addWidget(m_view, 1);
    connect(m_part, &QComboBox::activated, this, &LatentPanel::refresh);
    connect(&variation, &CurrentVariation::resultChanged, this, &LatentPanel::refreshParts);
    connect(&variation.view().player(), &Player::frameChanged, this, &LatentPanel::followPlayer);
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &LatentPanel::refresh);
    connect(m_view, &widgets::LatentView::activated, this,
            [this](int /*path*/, int frame) { m_variation.goToReference(frame); });
    retranslates(this, [this] {
        m_part->setAccessibleName(tr("Part"));
        m_part->setToolTip(tr("The part of the body whose latent space is shown"));
        m_view->setAccessibleName(tr("Latent space"));
        m_view->setEmptyText(
            tr("Each take becomes a line in the latent space of a part, once the movement is learned."));
        refreshParts();
    });
}

void LatentPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refreshParts();
}

const PartProgress* LatentPanel::part() const
{
    const auto& parts = m_variation.parts();
    const auto index = static_cast<std::size_t>(std::max(m_part->currentIndex(), 0));
    return index < parts.size() ? &parts[index] : nullptr;
}

void LatentPanel::refreshParts()
{
    const QSignalBlocker blocker(m_part);
    QStringList names;
    for (const PartProgress& part : m_variation.parts())
        names += QString::fromStdString(part.part);
    QStringList shown;
    for (int i = 0; i < m_part->count(); ++i)
        shown += m_part->itemText(i);
    if (names != shown) {
        const QString before = m_part->currentText();
        m_part->clear();
        m_part->addItems(names);
        m_part->setCurrentIndex(std::max(m_part->findText(before), names.isEmpty() ? -1 : 0));
    }
    m_part->setVisible(names.size() > 1);
    if (isVisible())
        refresh();
}

/// A line for each take that was learned from, then for each variation that is shown.
std::vector<LatentPath> LatentPanel::paths(const PartProgress& part) const
{
    const auto movement = m_variation.movement();
    std::vector<LatentPath> paths;
    const auto place = static_cast<std::size_t>(std::max(m_part->currentIndex(), 0));
    if (movement == nullptr || place >= movement->training.size())
        return paths;
    const std::vector<RowSpan>& spans = movement->training[place].spans;
    for (std::size_t take = 0; take < spans.size(); ++take) {
        if (spans[take].last() >= part.state.latents.rows())
            break;
        // Blends that are learned, too, are many: they say what they are when pointed at.
        LatentPath path{.name = QString::fromStdString(movement->take(take).name),
                        .color = take < movement->capturedCount()
                                     ? widgets::Theme::categorical(firstTakeColor + static_cast<int>(take))
                                     : widgets::Theme::color(widgets::ColorRole::TextMuted),
                        .points = placesOf(part.state.latents, spans[take].first, spans[take].count),
                        .isNamed = take < movement->capturedCount()};
        paths.push_back(std::move(path));
    }
    for (const DrawnVariation& drawn : m_variation.drawn()) {
        if (drawn.isDiscarded || m_variation.isHidden(drawn.inSet) || place >= drawn.latents.size())
            continue;
        const RowMatrix& latents = drawn.latents[place];
        paths.push_back({.name = tr("Variation %1").arg(drawn.inSet),
                         .color = CurrentVariation::colorOf(drawn.inSet),
                         .isSample = true,
                         .points = placesOf(latents, 0, latents.rows())});
    }
    return paths;
}

void LatentPanel::refresh()
{
    const PartProgress* shown = part();
    m_view->setDimensions(shown == nullptr ? 3 : static_cast<int>(shown->state.latents.cols()));
    m_view->setPaths(shown == nullptr ? std::vector<LatentPath>() : paths(*shown));
    followPlayer();
    askForConfidence();
}

void LatentPanel::followPlayer()
{
    const auto frame = m_variation.referenceFrame();
    m_view->setCurrent(std::vector<std::optional<double>>(m_view->paths().size(), frame));
}

/// Computed only while it is shown.
void LatentPanel::askForConfidence()
{
    if (m_job)
        m_job->cancel();
    const PartProgress* shown = part();
    if (!m_view->isConfidenceShown() || !isVisible() || shown == nullptr || !shown->stop || m_view->isEmpty())
        return;
    std::vector<RowMatrix> trajectories;
    for (const LatentPath& path : m_view->paths()) {
        RowMatrix trajectory =
            shown->state.latents.colwise().mean().replicate(static_cast<Eigen::Index>(path.points.size()), 1);
        for (Eigen::Index row = 0; row < trajectory.rows(); ++row)
            for (Eigen::Index axis = 0; axis < std::min<Eigen::Index>(trajectory.cols(), 3); ++axis)
                trajectory(row, axis) =
                    static_cast<double>(path.points[static_cast<std::size_t>(row)][static_cast<int>(axis)]);
        trajectories.push_back(std::move(trajectory));
    }
    const int asked = ++m_asked;
    m_job = m_variation.context().jobs.start(
        {.name = tr("Confidence of “%1”").arg(QString::fromStdString(shown->part)),
         .receiver = this,
         .stillStands = [this, asked] { return asked == m_asked; },
         .background = true},
        [state = shown->state, trajectories = std::move(trajectories)](const Progress& progress) {
            return confidenceOf(state, trajectories, progress);
        },
        [this](const LatentConfidence& confidence) {
            std::vector<LatentPath> paths = m_view->paths();
            for (std::size_t i = 0; i < paths.size() && i < confidence.alongPaths.size(); ++i)
                paths[i].values = confidence.alongPaths[i];
            widgets::LatentCloud cloud;
            for (const auto& [x, y, z] : confidence.places)
                cloud.points.emplace_back(static_cast<float>(x), static_cast<float>(y),
                                          static_cast<float>(z));
            cloud.values = confidence.atPlaces;
            m_view->setConfidence(std::move(cloud), {.minimum = confidence.least,
                                                     .maximum = confidence.greatest,
                                                     .title = tr("log₁₀ variance"),
                                                     .unit = QStringLiteral("m²")});
            m_view->setPaths(std::move(paths));
            followPlayer();
        });
}

} // namespace quadrille

#include "moc_latentpanel.cpp"

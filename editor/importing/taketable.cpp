// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/importing/taketable.h"

#include "editor/commands/entrynames.h"
#include "editor/errors/errortext.h"
#include "editor/fields/namedelegate.h"
#include "editor/jobs/jobrunner.h"
#include "editor/pictures/pictures.h"
#include "model/render/thumbnail.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QApplication>
#include <QHeaderView>
#include <QLocale>

namespace quadrille {

namespace {

constexpr int thumbnailSize = 48;

/// A small sign; unlike an icon it is not stretched to the size of the thumbnails.
QVariant sign(const char* icon, widgets::ColorRole color)
{
    return widgets::icons::pixmap(QLatin1String(icon), 16, widgets::Theme::color(color),
                                  qApp->devicePixelRatio());
}

QString textureText(const PlannedTake& planned)
{
    switch (planned.texture.kind) {
    case TextureReference::Kind::Single:
        return TakeTable::tr("one, chosen");
    case TextureReference::Kind::PerFrame:
        return TakeTable::tr("one per frame, chosen");
    case TextureReference::Kind::None:
    case TextureReference::Kind::PerMaterial:
        break;
    }
    const TextureSet& textures = planned.take.sequence->textures;
    const int count = static_cast<int>(textures.textures().size());
    switch (textures.kind()) {
    case TextureSet::Kind::None:
        return TakeTable::tr("none");
    case TextureSet::Kind::Single:
        return TakeTable::tr("one");
    case TextureSet::Kind::PerFrame:
        return TakeTable::tr("%n, one per frame", nullptr, count);
    case TextureSet::Kind::PerMaterial:
        return TakeTable::tr("%n, by material", nullptr, count);
    }
    return {};
}

} // namespace

TakeTable::TakeTable(JobRunner& jobs, QWidget* parent) : QTreeWidget(parent), m_jobs(jobs)
{
    setObjectName(QStringLiteral("importTakes"));
    setColumnCount(ColumnCount);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setIconSize({thumbnailSize, thumbnailSize});
    setEditTriggers(DoubleClicked | EditKeyPressed);
    setItemDelegateForColumn(
        NameColumn, new NameDelegate(
                        [](const QModelIndex&, const QString& name) { return problemWithText(name); }, this));
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* /*item*/, int column) {
        if (column == NameColumn)
            emit edited();
    });
}

void TakeTable::retranslate()
{
    setHeaderLabels({tr("Take"), tr("Frames"), tr("Rate"), tr("Mesh"), tr("Textures")});
    setAccessibleName(tr("Takes that were found"));
}

void TakeTable::setPlan(const ImportPlan& plan)
{
    const QSignalBlocker blocker(this);
    ++m_generation;
    const int current = std::max(0, currentTake());
    while (topLevelItemCount() > static_cast<int>(plan.takes.size()))
        delete takeTopLevelItem(topLevelItemCount() - 1);
    for (std::size_t i = 0; i < plan.takes.size(); ++i) {
        const PlannedTake& planned = plan.takes[i];
        const int row = static_cast<int>(i);
        if (row == topLevelItemCount())
            addTopLevelItem(new QTreeWidgetItem);
        fill(*topLevelItem(row), planned);
        if (planned.take.sequence)
            drawThumbnail(row, *planned.take.sequence,
                          planned.take.coordinates ? CoordinateSystem{} : plan.axes);
    }
    setCurrentItem(topLevelItem(std::min(current, topLevelItemCount() - 1)));
}

void TakeTable::fill(QTreeWidgetItem& item, const PlannedTake& planned) const
{
    const QString source = QString::fromStdString(planned.take.source.string());
    const bool isNew = item.data(NameColumn, Qt::UserRole).toString() != source;
    const bool isPossible = planned.canBeImported();
    item.setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled |
                  (isPossible ? Qt::ItemIsUserCheckable | Qt::ItemIsEditable : Qt::NoItemFlags));
    item.setData(NameColumn, Qt::UserRole, source);
    if (isNew || !isPossible) {
        item.setText(NameColumn, QString::fromStdString(planned.name));
        item.setCheckState(NameColumn, isPossible && planned.isWanted ? Qt::Checked : Qt::Unchecked);
    }
    item.setToolTip(NameColumn, source);
    const QLocale locale;
    if (!isPossible) {
        item.setData(NameColumn, Qt::DecorationRole, sign("error", widgets::ColorRole::Error));
        item.setText(FramesColumn, tr("cannot be opened"));
        for (const int column : {RateColumn, MeshColumn, TextureColumn})
            item.setText(column, {});
        item.setToolTip(NameColumn, describe(*planned.take.error).oneLine());
        return;
    }
    const MeshSequence& sequence = *planned.take.sequence;
    const bool hasWarning = std::ranges::any_of(
        planned.take.issues, [](const Issue& issue) { return issue.severity == Issue::Severity::Warning; });
    item.setText(FramesColumn, locale.toString(static_cast<qlonglong>(sequence.frameCount())));
    item.setData(FramesColumn, Qt::DecorationRole,
                 hasWarning ? sign("warning", widgets::ColorRole::WarningText) : QVariant());
    const double fps = planned.take.hasOwnFps ? sequence.fps : planned.rate.fps;
    item.setText(RateColumn, ImportPlan::isRateUnknown(planned)
                                 ? tr("unknown")
                                 : tr("%1 fps").arg(locale.toString(fps, 'g', 5)));
    item.setData(RateColumn, Qt::DecorationRole,
                 ImportPlan::isRateUnknown(planned) ? sign("warning", widgets::ColorRole::WarningText)
                                                    : QVariant());
    item.setText(MeshColumn, tr("%n vertices", nullptr, static_cast<int>(sequence.topology->vertexCount())));
    item.setText(TextureColumn, textureText(planned));
    for (const int column : {FramesColumn, RateColumn, MeshColumn})
        item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
}

void TakeTable::showValues(const ImportPlan& plan)
{
    const QSignalBlocker blocker(this);
    for (int row = 0; row < topLevelItemCount(); ++row)
        fill(*topLevelItem(row), plan.takes.at(static_cast<std::size_t>(row)));
}

bool TakeTable::isWanted(int take) const
{
    return topLevelItem(take)->checkState(NameColumn) == Qt::Checked;
}

QString TakeTable::nameOf(int take) const
{
    return topLevelItem(take)->text(NameColumn);
}

void TakeTable::drawThumbnail(int take, const MeshSequence& sequence, const CoordinateSystem& axes)
{
    const int pixels = static_cast<int>(thumbnailSize * devicePixelRatioF());
    const RenderOptions look = thumbnailLook(pixels, pixels, RenderOptions::Background::Transparent, axes);
    m_jobs.start(
        {.name = tr("Drawing “%1”").arg(QString::fromStdString(sequence.name)),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         .failed = [](const Error&) { /* told by the preview of the take */ },
         .background = true},
        [sequence, look](const Progress&) { return thumbnail(sequence, look); },
        [this, take, ratio = devicePixelRatioF()](Image picture) {
            QPixmap pixmap = QPixmap::fromImage(toQImage(std::move(picture)));
            pixmap.setDevicePixelRatio(ratio);
            const QSignalBlocker blocker(this);
            topLevelItem(take)->setIcon(NameColumn, pixmap);
        });
}

} // namespace quadrille

#include "moc_taketable.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/welcome/recentprojects.h"

#include "editor/application/session.h"
#include "editor/context/settings.h"
#include "editor/language/retranslate.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QShortcut>
#include <QStyledItemDelegate>
#include <QUrl>
#include <algorithm>

namespace quadrille {

namespace {

using widgets::ColorRole;
using widgets::Theme;

constexpr QSize pictureSize(160, 100);
constexpr int padding = 6;
constexpr int signSize = 24;
constexpr double corner = 4;

/// Paints the picture of a project, its name, and its folder or that it is missing.
class ProjectDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const override
    {
        return pictureSize + QSize(2 * padding, 3 * padding + 2 * option.fontMetrics.lineSpacing());
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        painter->save();
        painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
        const bool hasFocus = option.state.testFlag(QStyle::State_HasFocus);
        if (hasFocus || option.state.testFlag(QStyle::State_MouseOver)) {
            painter->setPen(hasFocus ? QPen(Theme::color(ColorRole::AccentText)) : QPen(Qt::NoPen));
            painter->setBrush(Theme::color(ColorRole::Hover));
            painter->drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), corner, corner);
        }
        const QRect picture(option.rect.topLeft() + QPoint(padding, padding), pictureSize);
        const bool isMissing = index.data(RecentProjects::MissingRole).toBool();
        paintPicture(*painter, picture, index.data(Qt::DecorationRole).value<QPixmap>(), isMissing);
        const int line = option.fontMetrics.lineSpacing();
        QRect text(picture.left(), picture.bottom() + padding, picture.width(), line);
        painter->setFont(option.font);
        painter->setPen(Theme::color(isMissing ? ColorRole::TextMuted : ColorRole::Text));
        painter->drawText(
            text, Qt::AlignLeft | Qt::AlignVCenter,
            option.fontMetrics.elidedText(index.data().toString(), Qt::ElideMiddle, text.width()));
        text.translate(0, line);
        const QString below =
            isMissing ? RecentProjects::tr("Not there any more")
                      : QDir::toNativeSeparators(
                            QFileInfo(index.data(RecentProjects::FileRole).toString()).absolutePath());
        painter->setPen(Theme::color(isMissing ? ColorRole::WarningText : ColorRole::TextMuted));
        painter->drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                          option.fontMetrics.elidedText(below, Qt::ElideMiddle, text.width()));
        painter->restore();
    }

private:
    static void paintPicture(QPainter& painter, const QRect& place, const QPixmap& picture, bool isMissing)
    {
        QPainterPath outline;
        outline.addRoundedRect(place, corner, corner);
        painter.fillPath(outline, Theme::color(ColorRole::Raised));
        if (!picture.isNull()) {
            constexpr double faint = 0.35;
            painter.save();
            painter.setClipPath(outline);
            painter.setOpacity(isMissing ? faint : 1.0);
            const QPixmap scaled = picture.scaled(place.size() * painter.device()->devicePixelRatioF(),
                                                  Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
            const QSize cut = place.size() * painter.device()->devicePixelRatioF();
            painter.drawPixmap(
                place, scaled,
                QRect(QPoint((scaled.width() - cut.width()) / 2, (scaled.height() - cut.height()) / 2), cut));
            painter.restore();
        }
        if (!picture.isNull() && !isMissing)
            return;
        QRect sign(0, 0, signSize, signSize);
        sign.moveCenter(place.center());
        painter.drawPixmap(sign,
                           widgets::icons::pixmap(
                               isMissing ? QStringLiteral("warning") : QStringLiteral("project"), signSize,
                               Theme::color(isMissing ? ColorRole::WarningText : ColorRole::TextMuted),
                               painter.device()->devicePixelRatioF()));
    }
};

} // namespace

RecentProjects::RecentProjects(Settings& settings, QWidget* parent)
    : QListWidget(parent), m_settings(settings)
{
    setObjectName(QStringLiteral("recentProjects"));
    setItemDelegate(new ProjectDelegate(this));
    setViewMode(QListView::IconMode);
    setMovement(QListView::Static);
    setResizeMode(QListView::Adjust);
    setUniformItemSizes(true);
    setMouseTracking(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setContextMenuPolicy(Qt::CustomContextMenu);
    viewport()->setAutoFillBackground(false);
    setStyleSheet(QStringLiteral("QListView { background: transparent; }"));
    auto* remove = new QShortcut(QKeySequence::Delete, this, nullptr, nullptr, Qt::WidgetShortcut);
    connect(remove, &QShortcut::activated, this, [this] {
        if (const QListWidgetItem* item = currentItem())
            forget(item->data(FileRole).toString());
    });
    connect(this, &QListWidget::itemActivated, this, &RecentProjects::ask);
    connect(this, &QListWidget::itemClicked, this, &RecentProjects::ask);
    connect(this, &QListWidget::customContextMenuRequested, this, &RecentProjects::showMenu);
    connect(&settings, &Settings::recentProjectsChanged, this, &RecentProjects::refresh);
    retranslates(this, [this] {
        setAccessibleName(tr("Recent projects"));
        refresh();
    });
}

void RecentProjects::refresh()
{
    const QString before = currentItem() == nullptr ? QString() : currentItem()->data(FileRole).toString();
    clear();
    for (const QString& file : m_settings.recentProjects()) {
        const QFileInfo info(file);
        auto* item = new QListWidgetItem(info.completeBaseName(), this);
        item->setData(Qt::DecorationRole, QPixmap(thumbnailFile(file)));
        item->setData(FileRole, file);
        item->setData(MissingRole, !info.exists());
        item->setToolTip(info.exists() ? file : tr("%1 is not there any more. Del forgets it.").arg(file));
        if (file == before)
            setCurrentItem(item);
    }
    fitHeight();
    emit refreshed();
}

void RecentProjects::forget(const QString& file)
{
    m_settings.removeRecentProject(file);
}

void RecentProjects::ask(const QListWidgetItem* item)
{
    const QString file = item->data(FileRole).toString();
    if (item->data(MissingRole).toBool())
        emit missingRequested(file);
    else
        emit projectRequested(file);
}

void RecentProjects::showMenu(const QPoint& position)
{
    const QListWidgetItem* under = itemAt(position);
    const QListWidgetItem* item = under == nullptr ? currentItem() : under;
    if (item == nullptr)
        return;
    const QString file = item->data(FileRole).toString();
    const bool isMissing = item->data(MissingRole).toBool();
    const QPoint place = viewport()->mapToGlobal(under == nullptr ? visualItemRect(item).center() : position);
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("recentProjectMenu"));
    menu.addAction(tr("Open"), this, [this, file] { emit projectRequested(file); })->setEnabled(!isMissing);
    menu.addAction(tr("Show in its folder"), this,
                   [file] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(file).absolutePath())); })
        ->setEnabled(!isMissing);
    menu.addSeparator();
    menu.addAction(tr("Remove from this list"), this, [this, file] { forget(file); });
    menu.exec(place);
}

/// As many rows as there are, at the width that there is.
void RecentProjects::fitHeight()
{
    if (count() == 0)
        return;
    const QSize cell = sizeHintForIndex(model()->index(0, 0));
    const int columns = std::max(1, viewport()->width() / std::max(cell.width(), 1));
    const int rows = (count() + columns - 1) / columns;
    setFixedHeight(rows * cell.height() + 2);
}

void RecentProjects::resizeEvent(QResizeEvent* event)
{
    QListWidget::resizeEvent(event);
    fitHeight();
}

void RecentProjects::changeEvent(QEvent* event)
{
    QListWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        fitHeight();
}

} // namespace quadrille

#include "moc_recentprojects.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/jobspopup.h"

#include "editor/jobs/joblistmodel.h"
#include "editor/language/retranslate.h"
#include "widgets/theme/icons.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <algorithm>

namespace quadrille {

JobsPopup::JobsPopup(JobListModel& jobs, QWidget* parent)
    : QFrame(parent, Qt::Popup), m_jobs(jobs), m_column(new QVBoxLayout(this))
{
    setObjectName(QStringLiteral("jobsPopup"));
    setFrameShape(QFrame::StyledPanel);
    constexpr int leastWidth = 320;
    setMinimumWidth(leastWidth);
    m_column->setContentsMargins(12, 8, 8, 8);
    m_column->setSpacing(8);
    for (const auto changed : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(&m_jobs, changed, this, &JobsPopup::refresh);
    connect(&m_jobs, &QAbstractItemModel::dataChanged, this, &JobsPopup::refresh);
    retranslates(this, [this] {
        setAccessibleName(tr("Running jobs"));
        refresh();
    });
}

void JobsPopup::showAbove(const QPoint& corner)
{
    m_corner = corner;
    refresh();
    show();
    place();
    if (!m_rows.empty())
        m_rows.front().cancel->setFocus(Qt::PopupFocusReason);
}

void JobsPopup::place()
{
    adjustSize();
    move(m_corner - QPoint(width(), height()));
}

void JobsPopup::addRow()
{
    Row row{new QWidget, new QLabel, new QLabel, new QProgressBar, new QToolButton};
    row.name->setObjectName(QStringLiteral("jobRowName"));
    row.timeLeft->setObjectName(QStringLiteral("jobRowTimeLeft"));
    row.timeLeft->setForegroundRole(QPalette::PlaceholderText);
    row.progress->setTextVisible(false);
    row.progress->setRange(0, 1000);
    row.cancel->setObjectName(QStringLiteral("jobRowCancel"));
    row.cancel->setIcon(widgets::icons::icon(QStringLiteral("cancel")));
    row.cancel->setAutoRaise(true);
    row.cancel->setFocusPolicy(Qt::StrongFocus);
    auto* grid = new QGridLayout(row.widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    grid->addWidget(row.name, 0, 0);
    grid->addWidget(row.timeLeft, 0, 1, Qt::AlignRight);
    grid->addWidget(row.progress, 1, 0, 1, 2);
    grid->addWidget(row.cancel, 0, 2, 2, 1);
    grid->setColumnStretch(0, 1);
    m_column->addWidget(row.widget);
    connect(row.cancel, &QToolButton::clicked, this, [this, widget = row.widget] { cancelRow(widget); });
    m_rows.push_back(row);
}

void JobsPopup::cancelRow(const QWidget* widget)
{
    const auto found =
        std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& row) { return row.widget == widget; });
    m_jobs.cancel(m_jobs.index(static_cast<int>(found - m_rows.begin())));
}

void JobsPopup::refresh()
{
    const auto count = static_cast<std::size_t>(m_jobs.rowCount());
    const bool hasChanged = count != m_rows.size();
    while (m_rows.size() < count)
        addRow();
    while (m_rows.size() > count) {
        m_rows.back().widget->hide();
        m_rows.back().widget->deleteLater();
        m_rows.pop_back();
    }
    for (std::size_t i = 0; i < count; ++i) {
        const QModelIndex index = m_jobs.index(static_cast<int>(i));
        const Row& row = m_rows[i];
        const QString name = index.data(Qt::DisplayRole).toString();
        const bool isCancelling =
            index.data(JobListModel::StateRole).value<Job::State>() == Job::State::Cancelling;
        row.name->setText(name);
        row.timeLeft->setText(isCancelling ? tr("stopping…")
                                           : index.data(JobListModel::TimeLeftRole).toString());
        row.progress->setValue(
            static_cast<int>(1000 * std::max(0.0, index.data(JobListModel::FractionRole).toDouble())));
        row.progress->setAccessibleName(name);
        row.cancel->setEnabled(!isCancelling);
        row.cancel->setToolTip(tr("Cancel “%1”").arg(name));
        row.cancel->setAccessibleName(row.cancel->toolTip());
    }
    if (!isVisible())
        return;
    if (count == 0)
        close();
    else if (hasChanged)
        place();
}

} // namespace quadrille

#include "moc_jobspopup.cpp"

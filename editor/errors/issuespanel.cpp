// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/errors/issuespanel.h"

#include "editor/errors/issuelog.h"
#include "editor/language/retranslate.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

namespace quadrille {

namespace {

QStyle::StandardPixmap signOf(IssueLog::Severity severity)
{
    switch (severity) {
    case IssueLog::Severity::Error:
        return QStyle::SP_MessageBoxCritical;
    case IssueLog::Severity::Warning:
        return QStyle::SP_MessageBoxWarning;
    case IssueLog::Severity::Info:
        break;
    }
    return QStyle::SP_MessageBoxInformation;
}

/// Draws the sign of the severity before the message.
class SeverityDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->features |= QStyleOptionViewItem::HasDecoration;
        option->decorationSize = QSize(16, 16);
        const QStyle* const style = option->widget ? option->widget->style() : QApplication::style();
        option->icon =
            style->standardIcon(signOf(index.data(IssueLog::SeverityRole).value<IssueLog::Severity>()));
    }
};

QToolButton* addButton(QBoxLayout& row, const QString& name)
{
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setAutoRaise(true);
    row.addWidget(button);
    return button;
}

} // namespace

IssuesPanel::IssuesPanel(IssueLog& log, QWidget* parent)
    : QWidget(parent)
    , m_log(log)
    , m_list(new QTreeView)
    , m_summary(new QLabel)
    , m_empty(new QLabel)
    , m_pages(new QStackedWidget)
{
    setObjectName(QStringLiteral("issuesPanel"));
    m_list->setObjectName(QStringLiteral("issuesList"));
    m_list->setModel(&log);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAllColumnsShowFocus(true);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setItemDelegateForColumn(IssueLog::MessageColumn, new SeverityDelegate(m_list));
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(IssueLog::MessageColumn, QHeaderView::Stretch);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_list);

    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 4, 4, 4);
    row->addWidget(m_summary, 1);
    m_show = addButton(*row, QStringLiteral("issuesShow"));
    m_clear = addButton(*row, QStringLiteral("issuesClear"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(row);
    column->addWidget(m_pages, 1);

    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_list, &QTreeView::customContextMenuRequested, this, &IssuesPanel::showMenu);
    connect(m_list, &QTreeView::activated, &log, &IssueLog::jump);
    connect(m_show, &QToolButton::clicked, this, [this] { m_log.jump(m_list->currentIndex()); });
    connect(m_clear, &QToolButton::clicked, this, [this] { m_log.clear(); });
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &IssuesPanel::updateState);
    connect(&log, &QAbstractItemModel::rowsInserted, this, &IssuesPanel::updateState);
    connect(&log, &QAbstractItemModel::rowsRemoved, this, &IssuesPanel::updateState);
    connect(&log, &QAbstractItemModel::modelReset, this, &IssuesPanel::updateState);
    retranslates(this, [this] { retranslate(); });
}

void IssuesPanel::showMenu(const QPoint& position)
{
    const QModelIndex issue = m_list->indexAt(position);
    QMenu menu(m_list);
    if (issue.isValid()) {
        QAction* show = menu.addAction(tr("Show what it is about"), &m_log, [&] { m_log.jump(issue); });
        show->setEnabled(issue.data(IssueLog::CanJumpRole).toBool());
        menu.addAction(tr("Copy the text"), &m_log, [&] {
            QApplication::clipboard()->setText(
                issue.siblingAtColumn(IssueLog::MessageColumn).data().toString());
        });
    }
    menu.addAction(tr("Forget all issues"), &m_log, [this] { m_log.clear(); });
    menu.exec(m_list->viewport()->mapToGlobal(position));
}

void IssuesPanel::retranslate()
{
    m_list->setAccessibleName(tr("Issues"));
    m_show->setText(tr("Show"));
    m_show->setToolTip(tr("Go to what the issue is about"));
    m_clear->setText(tr("Clear"));
    m_clear->setToolTip(tr("Forget all issues"));
    m_empty->setText(tr("No issues. What goes wrong, and what an import had to repair, is listed here."));
    m_log.retranslate();
    updateState();
}

void IssuesPanel::updateState()
{
    const int errors = m_log.count(IssueLog::Severity::Error);
    const int warnings = m_log.count(IssueLog::Severity::Warning);
    const QString errorText = tr("%n error(s)", nullptr, errors);
    const QString warningText = tr("%n warning(s)", nullptr, warnings);
    m_summary->setText(tr("%1 · %2", "numbers of errors and of warnings").arg(errorText, warningText));
    const bool isEmpty = m_log.rowCount() == 0;
    m_summary->setVisible(!isEmpty);
    m_pages->setCurrentIndex(isEmpty ? 0 : 1);
    m_clear->setEnabled(!isEmpty);
    m_show->setEnabled(m_list->currentIndex().data(IssueLog::CanJumpRole).toBool());
}

} // namespace quadrille

#include "moc_issuespanel.cpp"

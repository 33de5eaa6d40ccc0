// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/rightmenu.h"

#include "editor/language/retranslate.h"
#include "widgets/theme/icons.h"

#include <QAbstractItemView>
#include <QAction>
#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QStringList>
#include <algorithm>

namespace quadrille {

namespace {

struct RightMenu
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::RightMenu)
};

QString textOf(const QModelIndex& row)
{
    QStringList columns;
    for (int column = 0; column < row.model()->columnCount(row.parent()); ++column)
        columns += row.siblingAtColumn(column).data().toString();
    return columns.join(QLatin1Char('\t'));
}

void copyRows(const QAbstractItemView& list)
{
    QModelIndexList rows = list.selectionModel()->selectedRows();
    if (rows.isEmpty() && list.currentIndex().isValid())
        rows = {list.currentIndex().siblingAtColumn(0)};
    std::sort(rows.begin(), rows.end());
    QStringList lines;
    for (const QModelIndex& row : rows)
        lines += textOf(row);
    QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

} // namespace

void addRightMenu(QAbstractItemView& list, const QList<QAction*>& actions)
{
    list.addActions(actions);
    if (!actions.isEmpty()) {
        auto* line = new QAction(&list);
        line->setSeparator(true);
        list.addAction(line);
    }
    auto* copy = new QAction(&list);
    copy->setObjectName(QStringLiteral("copyRows"));
    copy->setIcon(widgets::icons::icon(QStringLiteral("copy")));
    retranslates(&list, [copy] { copy->setText(RightMenu::tr("Copy as &text")); });
    QObject::connect(copy, &QAction::triggered, &list, [&list] { copyRows(list); });
    list.addAction(copy);
    list.setContextMenuPolicy(Qt::ActionsContextMenu);
}

} // namespace quadrille

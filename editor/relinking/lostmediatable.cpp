// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/relinking/lostmediatable.h"

#include "editor/documents/projectpaths.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QApplication>
#include <QHeaderView>

namespace quadrille {

namespace {

/// "walk, texture".
QString userOf(const MediaUse& use)
{
    const QString name = QString::fromStdString(use.owner.substr(use.owner.find('/') + 1));
    const auto endsWith = [&](const char* key) { return use.pointer.ends_with(key); };
    if (endsWith("/mesh"))
        return LostMediaTable::tr("%1, mesh").arg(name);
    if (endsWith("/texture"))
        return LostMediaTable::tr("%1, texture").arg(name);
    if (endsWith("/joint_angles"))
        return LostMediaTable::tr("%1, joint angles").arg(name);
    return LostMediaTable::tr("%1, frames").arg(name);
}

QVariant signOf(const LostMedium& medium)
{
    struct Sign
    {
        const char* icon;
        widgets::ColorRole color;
    };
    Sign sign{"success", widgets::ColorRole::SuccessText};
    if (!medium.isFound())
        sign = {"error", widgets::ColorRole::Error};
    else if (medium.found.match == MediaMatch::OtherContent || medium.found.isAmbiguous)
        sign = {"warning", widgets::ColorRole::WarningText};
    return widgets::icons::pixmap(QLatin1String(sign.icon), 16, widgets::Theme::color(sign.color),
                                  qApp->devicePixelRatio());
}

} // namespace

LostMediaTable::LostMediaTable(QWidget* parent) : QTreeWidget(parent)
{
    setObjectName(QStringLiteral("relinkTable"));
    setColumnCount(ColumnCount);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setTextElideMode(Qt::ElideMiddle);
    header()->setStretchLastSection(false);
    for (const int column : {OldColumn, NewColumn})
        header()->setSectionResizeMode(column, QHeaderView::Stretch);
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* /*item*/, int column) {
        if (column == FileColumn)
            emit ticked();
    });
}

void LostMediaTable::retranslate()
{
    setHeaderLabels({tr("File"), tr("Used by"), tr("State"), tr("Was in"), tr("Is in")});
    setAccessibleName(tr("Files that are missing"));
}

QString LostMediaTable::stateOf(const LostMedium& medium)
{
    switch (medium.found.match) {
    case MediaMatch::Missing:
        return tr("missing");
    case MediaMatch::OtherContent:
        return medium.isByHand ? tr("chosen, but different content") : tr("found, but different content");
    case MediaMatch::Name:
        return medium.isByHand ? tr("chosen by hand") : tr("found by name");
    case MediaMatch::Content:
        return tr("found by content");
    case MediaMatch::NameAndContent:
        return tr("found by name and content");
    }
    return {};
}

QString LostMediaTable::explanationOf(const LostMedium& medium)
{
    switch (medium.found.match) {
    case MediaMatch::Missing:
        return tr("Not found yet. Search a folder, or choose it by hand.");
    case MediaMatch::OtherContent:
        return tr("The content is not the one that the project used. Tick it only if you want to use it all "
                  "the same.");
    case MediaMatch::Name:
        if (medium.found.isAmbiguous)
            return tr(
                "Several have this name; the one whose folders are most alike was taken. Choose another "
                "by hand if it is the wrong one.");
        return tr("The content was never noted, so it cannot be compared.");
    case MediaMatch::Content:
        return tr("The name is another, but the content is the one that the project used.");
    case MediaMatch::NameAndContent:
        return tr("Name and content are those that the project used.");
    }
    return {};
}

void LostMediaTable::fill(QTreeWidgetItem& item, const LostMedium& medium)
{
    const auto show = [&item](Column column, const QString& text, const QString& tip) {
        item.setText(column, text);
        item.setToolTip(column, tip);
    };
    QStringList users;
    for (const MediaUse& use : medium.uses)
        users << userOf(use);
    const QString oldFile = QString::fromStdString(medium.path);
    const QString newFile = toQString(medium.found.file);
    const QString oldName = toQString(toPath(oldFile).filename());
    const QString newName = toQString(medium.found.file.filename());
    show(FileColumn, oldName, oldFile);
    show(UsersColumn,
         users.size() > 2
             ? tr("%1 and %n more", nullptr, static_cast<int>(users.size()) - 1).arg(users.front())
             : users.join(tr("; ", "between users of a file")),
         users.join(QLatin1Char('\n')));
    show(StateColumn, stateOf(medium), explanationOf(medium));
    show(OldColumn, toQString(toPath(oldFile).parent_path()), oldFile);
    show(NewColumn, newName == oldName ? toQString(medium.found.file.parent_path()) : newFile, newFile);
    item.setData(StateColumn, Qt::DecorationRole, signOf(medium));
    item.setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled |
                  (medium.isFound() ? Qt::ItemIsUserCheckable : Qt::NoItemFlags));
    item.setData(FileColumn, Qt::CheckStateRole,
                 medium.isFound() ? QVariant(medium.isWanted ? Qt::Checked : Qt::Unchecked) : QVariant());
}

void LostMediaTable::setPlan(const RelinkPlan& plan)
{
    const QSignalBlocker blocker(this);
    const int current = std::max(0, currentMedium());
    while (topLevelItemCount() > static_cast<int>(plan.media.size()))
        delete takeTopLevelItem(topLevelItemCount() - 1);
    for (std::size_t i = 0; i < plan.media.size(); ++i) {
        const int row = static_cast<int>(i);
        if (row == topLevelItemCount())
            addTopLevelItem(new QTreeWidgetItem);
        fill(*topLevelItem(row), plan.media[i]);
    }
    constexpr int gap = 16;
    for (const int column : {FileColumn, UsersColumn, StateColumn}) {
        resizeColumnToContents(column);
        setColumnWidth(column, columnWidth(column) + gap);
    }
    setCurrentItem(topLevelItem(std::min(current, topLevelItemCount() - 1)));
}

bool LostMediaTable::isWanted(int medium) const
{
    return topLevelItem(medium)->checkState(FileColumn) == Qt::Checked;
}

} // namespace quadrille

#include "moc_lostmediatable.cpp"

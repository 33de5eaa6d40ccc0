// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/view/notespanel.h"

#include "editor/fields/ownkeys.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/view/framenotes.h"
#include "widgets/theme/theme.h"
#include "widgets/timeline/timelinescale.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QScopedValueRollback>

namespace quadrille {

namespace {

enum Column
{
    FrameColumn,
    TimeColumn,
    WordsColumn,
    ColumnCount
};

} // namespace

NotesPanel::NotesPanel(FrameNotes& notes, QWidget* parent) : QTreeWidget(parent), m_notes(notes)
{
    setObjectName(QStringLiteral("notesPanel"));
    setColumnCount(ColumnCount);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setFrameShape(QFrame::NoFrame);
    setFont(widgets::Theme::tabularFont(font()));
    setMinimumHeight(48);
    header()->setSectionResizeMode(FrameColumn, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(TimeColumn, QHeaderView::ResizeToContents);
    setContextMenuPolicy(Qt::CustomContextMenu);
    connect(this, &QTreeWidget::customContextMenuRequested, this, &NotesPanel::showMenu);
    connect(this, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
        if (!m_isFilling && item != nullptr)
            m_notes.goTo(current());
    });
    connect(this, &QTreeWidget::itemClicked, this, [this] { m_notes.goTo(current()); });
    connect(this, &QTreeWidget::itemDoubleClicked, this, [this] { m_notes.edit(current()); });
    retranslates(this, [this] {
        setHeaderLabels({tr("Frame"), tr("At"), tr("Note")});
        setAccessibleName(tr("Notes"));
    });
}

void NotesPanel::refresh(double fps)
{
    const QScopedValueRollback filling(m_isFilling, true);
    const int before = current();
    clear();
    for (const FrameNote& note : m_notes.notes()) {
        auto* item = new QTreeWidgetItem(this);
        const int frame = m_notes.frameOf(note);
        item->setText(FrameColumn, QString::number(frame));
        item->setText(TimeColumn, widgets::timeText(frame / fps));
        item->setText(WordsColumn, QString::fromStdString(note.text));
        item->setToolTip(WordsColumn, item->text(WordsColumn));
        for (const int column : {FrameColumn, TimeColumn})
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    setCurrentItem(topLevelItem(std::min(before, topLevelItemCount() - 1)));
}

void NotesPanel::showMenu(const QPoint& position)
{
    if (itemAt(position) == nullptr)
        return;
    QMenu menu(this);
    menu.addAction(tr("Edit the note"), this, [this] { m_notes.edit(current()); });
    menu.addAction(tr("Remove the note"), this, [this] { m_notes.remove(current()); });
    menu.exec(viewport()->mapToGlobal(position));
}

bool NotesPanel::event(QEvent* event)
{
    return takesOwnKeys(*event, {Qt::Key_Delete, Qt::Key_F2}) || QTreeWidget::event(event);
}

void NotesPanel::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    if (current() >= 0 && key == Qt::Key_Delete)
        m_notes.remove(current());
    else if (current() >= 0 && (key == Qt::Key_F2 || key == Qt::Key_Return || key == Qt::Key_Enter))
        m_notes.edit(current());
    else
        QTreeWidget::keyPressEvent(event);
}

void NotesPanel::paintEvent(QPaintEvent* event)
{
    QTreeWidget::paintEvent(event);
    if (topLevelItemCount() > 0)
        return;
    QPainter painter(viewport());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect().adjusted(8, 4, -8, -4), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("No notes. Shift+N writes one on the frame that is shown."));
}

} // namespace quadrille

#include "moc_notespanel.cpp"

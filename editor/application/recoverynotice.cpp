// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/recoverynotice.h"

#include "editor/language/retranslate.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace quadrille {

RecoveryNotice::RecoveryNotice(QWidget* parent) : QWidget(parent), m_rows(new QVBoxLayout(this))
{
    setObjectName(QStringLiteral("recoveryNotice"));
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setSpacing(4);
    retranslates(this, [this] { refresh(); });
}

void RecoveryNotice::refresh()
{
    while (QLayoutItem* item = m_rows->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    for (const Recovery& recovery : findRecoveries().works)
        m_rows->addWidget(makeRow(recovery));
}

QWidget* RecoveryNotice::makeRow(const Recovery& recovery)
{
    auto* row = new QWidget;
    auto* text =
        new QLabel(tr("Unsaved work: “%1”, %2, %n entries", nullptr, recovery.entryCount())
                       .arg(recovery.title(), QLocale().toString(recovery.saved, QLocale::ShortFormat)));
    text->setObjectName(QStringLiteral("recoveryText"));
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    text->setToolTip(recovery.projectFile);
    auto* recover = new QPushButton(tr("Recover"));
    recover->setObjectName(QStringLiteral("recoveryRecover"));
    auto* discard = new QPushButton(tr("Discard"));
    discard->setObjectName(QStringLiteral("recoveryForget"));
    discard->setToolTip(tr("Deletes this copy for good"));
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(text, 1);
    layout->addWidget(recover);
    layout->addWidget(discard);
    connect(recover, &QPushButton::clicked, this, [this, recovery] { emit recoverRequested(recovery); });
    connect(discard, &QPushButton::clicked, this, [this, id = recovery.id] {
        discardRecovery(id);
        refresh();
    });
    return row;
}

void RecoveryNotice::showEvent(QShowEvent* event)
{
    refresh();
    QWidget::showEvent(event);
}

} // namespace quadrille

#include "moc_recoverynotice.cpp"

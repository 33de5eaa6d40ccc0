// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/exporting/exportdialog.h"
#include "editortest.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>

namespace quadrille::test {

/// The one that is open; null where none is.
inline ExportDialog* exportDialog()
{
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* found = qobject_cast<ExportDialog*>(widget); found != nullptr && found->isVisible())
            return found;
    }
    return nullptr;
}

/// Chooses a format with the keyboard.
inline void chooseExportFormat(const QString& format)
{
    auto* box = find<QComboBox>("exportFormat");
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    while (box->currentData().toString() != format && box->currentIndex() + 1 < box->count())
        QTest::keyClick(box, Qt::Key_Down);
    QCOMPARE(box->currentData().toString(), format);
}

inline void typeExportPlace(const QString& path)
{
    auto* field = find<QLineEdit>("exportPlace");
    field->selectAll();
    QTest::keyClicks(field, path);
}

inline void acceptExport()
{
    QTest::mouseClick(find<QPushButton>("exportAccept"), Qt::LeftButton);
}

inline bool isExportDone()
{
    return find<QPushButton>("exportAccept")->text() == "Close";
}

/// Exports, waits until all is written, and closes the dialog.
inline void acceptAndCloseExport()
{
    acceptExport();
    QTRY_VERIFY(isExportDone());
    acceptExport();
    QTRY_VERIFY(exportDialog() == nullptr);
}

} // namespace quadrille::test

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QTreeWidget>

namespace quadrille {

class FrameNotes;

/// The notes of what is worked on as a list. A click goes to the frame, F2 edits, Delete takes away.
class NotesPanel : public QTreeWidget
{
    Q_OBJECT

public:
    explicit NotesPanel(FrameNotes& notes, QWidget* parent = nullptr);

    /// \param fps  of what the notes are on.
    void refresh(double fps);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void showMenu(const QPoint& position);
    int current() const { return indexOfTopLevelItem(currentItem()); }

    FrameNotes& m_notes;
    bool m_isFilling = false;
};

} // namespace quadrille

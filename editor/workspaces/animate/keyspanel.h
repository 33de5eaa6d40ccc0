// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTableView;
class QToolButton;

namespace quadrille {

class CurrentAnimation;
class FramePictures;
class KeysModel;

namespace widgets {
class ElidedLabel;
} // namespace widgets

/// The keys of the animation as a table of wanted and obtained times.
class KeysPanel : public QWidget
{
    Q_OBJECT

public:
    KeysPanel(CurrentAnimation& animation, FramePictures& pictures, QWidget* parent = nullptr);

    /// −1 for none. Emits nothing.
    void selectKey(int key);
    /// Opens the field of its wanted time. \param key  from 0.
    void editKey(int key);

signals:
    void keySelected(int key);
    /// Double click: to be shown.
    void keyChosen(int key);
    /// The panel itself removes nothing.
    void removalRequested(int key);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void arrange();
    void editCell(int key, int column);
    void follow();
    void showMenu(const QPoint& position);
    int selected() const;

    CurrentAnimation& m_animation;
    KeysModel* m_model;
    QTableView* m_table;
    QStackedWidget* m_pages;
    widgets::ElidedLabel* m_empty;
    QPushButton* m_addFirst;
    QLabel* m_summary;
    QToolButton* m_add;
    QToolButton* m_remove;
    QCheckBox* m_global;
    bool m_isTaking = false;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QTreeWidgetItem;

namespace quadrille {

class BlendList;
class CurrentVariation;
class SettingForm;
class TakeList;

namespace widgets {
class ElidedButton;
} // namespace widgets

/// Which takes variations are learned from, and how they are brought into one timing and one place.
class MovementPanel : public QWidget
{
    Q_OBJECT

public:
    explicit MovementPanel(CurrentVariation& variation, QWidget* parent = nullptr);

private:
    void addSettings();
    void refresh();
    void refreshTakes();
    void showUse(QTreeWidgetItem& item);
    void choose(QTreeWidgetItem* item);
    void addTakes(const QStringList& takes);
    void takeTemplate();
    QStringList takesOfCharacter() const;

    CurrentVariation& m_variation;
    QLabel* m_hint;
    TakeList* m_takes;
    SettingForm* m_form;
    QComboBox* m_reference;
    widgets::ElidedButton* m_template;
    QCheckBox* m_cycles;
    QLabel* m_blendHeading;
    BlendList* m_blends;
    bool m_isShowing = false; ///< fields change because of the document
};

} // namespace quadrille

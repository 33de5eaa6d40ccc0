// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "model/project/document/variationentry.h"

class QTreeWidgetItem;

namespace quadrille {

class BlendList;
class CurrentVariation;
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
    void setTemplate(const std::optional<NamedFrame>& pose);
    QStringList takesOfCharacter() const;

    CurrentVariation& m_variation;
    QLabel* m_hint;
    TakeList* m_takes;
    SettingForm* m_form;
    FieldForm<VariationEntry> m_fields;
    widgets::ElidedButton* m_template;
    QLabel* m_blendHeading;
    BlendList* m_blends;
    bool m_isShowing = false; ///< fields change because of the document
};

} // namespace quadrille

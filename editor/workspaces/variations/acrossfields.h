// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"

#include <QWidget>
#include <functional>

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace quadrille {

namespace widgets {
class WeightsPad;
}

class CurrentVariation;

/// The second pair of a blend of four takes: which ones, where variations lie between all four, and whether
/// blends of them are learned.
class AcrossFields : public QWidget
{
    Q_OBJECT

public:
    explicit AcrossFields(CurrentVariation& variation, QWidget* parent = nullptr);

    /// Whether two more takes could lie across from those that are blended.
    bool isUseful() const;

private:
    using Edit = std::function<void(SamplesEntry&)>;

    void connectFields();
    void retranslate();
    void refresh();
    void refreshTakes(const SamplesEntry& set);
    void refreshPad(const SamplesEntry& set);
    void choose(int index);
    void learn();
    void editSet(const QString& text, const char* property, const Edit& edit,
                 EditPhase phase = EditPhase::Final);

    CurrentVariation& m_variation;
    QComboBox* m_of;
    QComboBox* m_to;
    QWidget* m_square; ///< all that is there with a second pair only
    widgets::WeightsPad* m_pad;
    QLabel* m_label;
    QSpinBox* m_percent;
    QPushButton* m_learn;
    bool m_isShowing = false; ///< fields change because of the document
};

/// Leaves a second pair out that can not be there any more. That is so without a blend, and where two of the
/// four takes are the same.
void dropImpossibleAcross(SamplesEntry& samples);

} // namespace quadrille

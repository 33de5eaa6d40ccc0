// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;
class QStackedWidget;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace quadrille {

class AcrossFields;
class CurrentVariation;
class PartList;
struct DrawnVariation;

/// What variations are drawn of, and those that were drawn: shown, kept, thrown away, added to the project,
/// exported.
class SamplesPanel : public QWidget
{
    Q_OBJECT

public:
    /// Registers the actions.
    explicit SamplesPanel(CurrentVariation& variation, QWidget* parent = nullptr);

signals:
    /// The user wants the variations as a data set.
    void exportRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeActions();
    QWidget* makeSets();
    QWidget* makeVariations();
    void connectFields();
    void retranslate();
    void refresh();
    void refreshSets();
    void refreshFields();
    void refreshVariations();
    void showVariation(QTreeWidgetItem& item, const DrawnVariation& drawn);
    void updateActions();
    void addSet();
    void removeSet();
    void editSet(const QString& text, const char* property, const std::function<void(SamplesEntry&)>& edit,
                 EditPhase phase = EditPhase::Final);
    void setWeight(int percent, EditPhase phase);
    void setSpread(double spread);
    void discard(bool discards);
    void addAsSequences();
    void makeClips(std::vector<std::string> clips);
    /// Those whose rows are selected.
    std::vector<DrawnVariation> selected() const;

    CurrentVariation& m_variation;
    QStackedWidget* m_pages;
    QLabel* m_empty;
    PartList* m_sets;
    QComboBox* m_of;
    QComboBox* m_to;
    QSlider* m_weight;
    QSpinBox* m_percent;
    QWidget* m_weightRow;
    QLabel* m_weightLabel;
    AcrossFields* m_across;
    QLabel* m_acrossLabel;
    QSpinBox* m_count;
    QSpinBox* m_seed;
    QDoubleSpinBox* m_spread;
    QToolButton* m_again;
    QLabel* m_summary;
    QTreeWidget* m_variations;
    QList<std::pair<QLabel*, std::function<QString()>>> m_labels;
    bool m_isShowing = false; ///< fields change because of the document
};

/// "walk 1", "walk 1 → jog 1, 40 %", or "walk 1 → jog 1, 40 % × walk 2 → jog 2, 50 %".
QString nameOf(const SamplesEntry& samples);

} // namespace quadrille

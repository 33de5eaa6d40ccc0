// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/fields/fieldform.h"

#include <string>
#include <vector>

class QStackedWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace quadrille {

class CurrentVariation;
class PartList;
class SliderField;
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
    void addTakes();
    void addWeight();
    void addDrawing();
    void connectLists();
    void retranslate();
    void refresh();
    void refreshSets();
    void refreshFields();
    void refreshVariations();
    void showVariation(QTreeWidgetItem& item, const DrawnVariation& drawn);
    void updateActions();
    void addSet();
    void removeSet();
    void discard(bool discards);
    void addAsSequences();
    void makeClips(std::vector<std::string> clips);
    /// Those whose rows are selected.
    std::vector<DrawnVariation> selected() const;

    CurrentVariation& m_variation;
    QStackedWidget* m_pages;
    QLabel* m_empty;
    PartList* m_sets;
    LabelForm* m_form;
    FieldForm<SamplesEntry, LabelForm> m_fields;
    FieldForm<VariationEntry, LabelForm> m_common; ///< of all sets alike
    SliderField* m_weight;
    QDoubleSpinBox* m_seed = nullptr;
    QLabel* m_summary;
    QTreeWidget* m_variations;
    bool m_isShowing = false; ///< fields change because of the document
};

/// "walk 1", "walk 1 → jog 1, 40 %", or "walk 1 → jog 1, 40 % × walk 2 → jog 2, 50 %".
QString nameOf(const SamplesEntry& samples);

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace quadrille {

class CurrentVariation;

/// The pairs of takes that are blended before learning, and at which weights of the second.
class BlendList : public QWidget
{
    Q_OBJECT

public:
    explicit BlendList(CurrentVariation& variation, QWidget* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    void refreshAdding();
    void add();
    void remove(int row);
    void takeWeights(QTreeWidgetItem* item);

    CurrentVariation& m_variation;
    QTreeWidget* m_blends;
    QLabel* m_hint;
    QComboBox* m_from;
    QComboBox* m_to;
    QPushButton* m_add;
    QWidget* m_adding; ///< what a blend is added with
    bool m_isShowing = false;
};

/// "25 %, 50 %".
QString weightsText(const std::vector<double>& weights);
/// The weights in a text as "25, 50 %": shares of one, ascending, each once, between 0 and 1; the others are
/// left out.
std::vector<double> weightsIn(const QString& text);

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QFontMetrics>
#include <QStyledItemDelegate>

namespace quadrille::widgets {

/// "walk 1 12 › run 2 34": where something goes from, and where to.
QString pairText(const QString& from, const QString& to);

/// A text of two names that shows the ends of both: each is shortened in its middle. Other texts are
/// shortened in their middle as a whole. \param width  pixels.
QString elidedPair(const QString& text, const QFontMetrics& metrics, int width);

/// Paints such texts in lists, tables and trees.
class PairDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

} // namespace quadrille::widgets

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/appearance/showntexture.h"

#include <QPointer>
#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace quadrille {

class SliderField;

namespace widgets {
class ComparedView;
class LegendBar;
} // namespace widgets

/// The texture view of the Appearance workspace: a pair of textures in one of several ways, with its quality
/// in numbers.
class TextureComparison : public QWidget
{
    Q_OBJECT

public:
    explicit TextureComparison(ShownTexture& shown, QWidget* parent = nullptr);
    ~TextureComparison() override;

    /// The one that masks are painted on.
    widgets::ComparedView& view() { return *m_view; }
    /// The pair that is shown now.
    const ShownPair& pair() const { return m_pair; }
    /// What stands where there is no texture.
    void setEmptyText(const QString& text);

signals:
    /// Another pair is shown.
    void pairShown();

private:
    void makeActions();
    void arrangeWidgets();
    void connectParts();
    void retranslate();
    void refresh();
    void refreshTools();
    void refreshEdges();
    void request();
    void take(ShownPair pair);
    void showPair();
    void showQuality();
    QString sideText(bool isFirst) const;

    ShownTexture& m_shown;
    JobRunner m_making; ///< of its own: long work of others must not hold it up
    widgets::ComparedView* m_view;
    widgets::ComparedView* m_right; ///< beside the first
    widgets::LegendBar* m_legend;
    QComboBox* m_content;
    QComboBox* m_mode;
    QToolButton* m_edges;
    QToolButton* m_fit;
    QLabel* m_usedLabel;
    SliderField* m_used;
    QLabel* m_quality;
    QLabel* m_note;
    ShownPair m_pair;
    QPointer<Job> m_job;
    bool m_isLate = false; ///< something else is wanted than what is being made
    QList<QLineF> m_lines; ///< of the UV layout
    std::weak_ptr<const Topology> m_linesOf;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/theme/colormap.h"
#include "widgets/viewport/ruler.h"
#include "widgets/viewport/scenemarks.h"
#include "widgets/viewport/viewtool.h"

#include <QPointer>
#include <QWidget>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::widgets {

/// What is written over a viewport's picture.
struct Annotations
{
    struct Name
    {
        QVector3D place; ///< above the figure
        QString text;
        QColor color;
        bool operator==(const Name&) const = default;
    };
    Turntable camera;
    Ruler ruler;
    std::vector<QVector3D> measured; ///< none, one or two points
    std::vector<Name> names;
    bool namesListed = false; ///< in a column, as figures in one place would hide each other's names
    std::vector<SceneLabel> labels;
    std::vector<QVector3D> handles; ///< of tools: labels keep clear of them
    /// Lower and upper corners of figures: labels beside them keep clear of them.
    std::vector<std::pair<QVector3D, QVector3D>> figures;
    std::optional<ScalarRange> legend;
    std::optional<ColorKey> key;
    QString notice; ///< in the middle

    bool operator==(const Annotations&) const = default;
    bool isEmpty() const
    {
        return measured.empty() && names.empty() && labels.empty() && !legend && !key && notice.isEmpty();
    }
};

/// Draws annotations into a rectangle that starts at the origin.
void paintAnnotations(QPainter& painter, const QSizeF& size, const Annotations& annotations);

/// A transparent sheet over the view; there only while something is to be written.
class ViewportOverlay : public QWidget
{
    Q_OBJECT
public:
    explicit ViewportOverlay(QWidget* parent);
    void show(const Annotations& annotations);
    const Annotations& annotations() const { return m_annotations; }
    /// Paints its handles over the words; null for none.
    void setTool(ViewTool* tool);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Annotations m_annotations;
    QPointer<ViewTool> m_tool;
};

} // namespace quadrille::widgets

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/workspaces/variations/partcurveroute.h"
#include "model/core/error.h"
#include "widgets/tools/surfacecurveeditor.h"

#include <QObject>
#include <functional>

namespace quadrille {

/// Understands what is done to the points of curves in a view: leads the curves over the body, and tells what
/// becomes of it. What cannot be is said in the view.
class PartCurveGestures : public QObject
{
    Q_OBJECT

public:
    using Edit = std::function<void(BodyPartsEntry&)>;

    /// \param content  outlives it, as does `editor`, whose gestures it takes.
    PartCurveGestures(const PartCurveContent& content, widgets::SurfaceCurveEditor& editor,
                      QObject* parent = nullptr);

    /// The curve that is drawn; empty before its first point.
    const std::string& drawn() const { return m_drawn; }
    /// Selects what was drawn.
    void finishDrawing();
    /// The body is another now, and with `surface` its surface, too.
    void forget(bool surface);

signals:
    /// \param text, property, phase  see CurrentVariation::editBody. \param edit  to be called at once.
    void edited(const QString& text, const QString& property, const quadrille::PartCurveGestures::Edit& edit,
                quadrille::EditPhase phase);

private:
    void addPoint(const widgets::SurfacePlace& place);
    void removeLastPoint();
    void preview(const std::optional<widgets::SurfacePlace>& place);
    void movePoint(int curve, int point, const widgets::SurfacePlace& place, bool committed);
    void cancelMove();
    void insertPoint(int curve, int after, const widgets::SurfacePlace& place);
    void removePoint(int curve, int point);
    void take(const PartCurveRoute& route, const QString& text, const QString& property,
              EditPhase phase = EditPhase::Final);
    void refuse(const Error& error);
    /// An entry of the content's, ready for edits; null for a new curve.
    std::unique_ptr<PartCurveRoute> routeOf(const PartCurveEntry* entry, bool snaps) const;

    const PartCurveContent& m_content;
    widgets::SurfaceCurveEditor& m_editor;
    std::string m_drawn;
    std::unique_ptr<PartCurveRoute> m_drag;
    std::unique_ptr<PartCurveRoute> m_trial; ///< the drawn curve with a point at the pointer
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/theme/theme.h"
#include "widgets/tools/surfacecurveeditor.h"
#include "widgets/tools/surfacevisibility.h"
#include "widgets/viewport/vtkview.h"

#include <QApplication>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <memory>

namespace quadrille::test {

using namespace quadrille::widgets;
using Kind = SurfaceCurvePart::Kind;
using Mode = SurfaceCurveEditor::Mode;

inline constexpr std::uint32_t around = 24; // vertices of a ring
inline constexpr std::uint32_t rings = 11;

/// An upright tube of radius 0.4 and height 2, without ends; vertex 0 of each ring is in front (+z), the
/// next ones go to the right.
inline FigureMesh tube()
{
    FigureMesh mesh;
    mesh.vertexCount = around * rings;
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = ring * around + i;
            const std::uint32_t b = ring * around + (i + 1) % around;
            mesh.triangles.push_back({a, b, b + around});
            mesh.triangles.push_back({a, b + around, a + around});
        }
    return mesh;
}

inline std::vector<float> tubePositions()
{
    std::vector<float> positions;
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t i = 0; i < around; ++i) {
            const double angle = 2.0 * M_PI * i / around;
            positions.push_back(static_cast<float>(0.4 * std::sin(angle)));
            positions.push_back(0.2F * static_cast<float>(ring) - 1.0F);
            positions.push_back(static_cast<float>(0.4 * std::cos(angle)));
        }
    return positions;
}

constexpr std::uint32_t vertexAt(std::uint32_t ring, std::uint32_t i)
{
    return ring * around + i;
}

/// A whole ring, with points in front, behind and at both sides.
inline ShownCurve ringCurve(std::uint32_t ring, const QString& name = {})
{
    ShownCurve curve;
    curve.name = name;
    for (std::uint32_t i = 0; i < around; ++i)
        curve.vertices.push_back(vertexAt(ring, i));
    curve.points = {0, 6, 12, 18};
    curve.color = Theme::color(ColorRole::Text);
    return curve;
}

/// A view of a tube, and the editor of curves on it.
class SurfaceCurveFixture : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();

protected:
    std::unique_ptr<Viewport> m_viewport;
    std::unique_ptr<SurfaceCurveEditor> m_editor;
    int m_figure = -1;
    std::vector<SurfacePlace> m_added;
    QPoint pixel(std::uint32_t vertex) const;
    void mouse(QEvent::Type type, const QPoint& at, Qt::KeyboardModifiers modifiers = {},
               Qt::MouseButton button = Qt::LeftButton);
    void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {});
    void key(int code, Qt::KeyboardModifiers modifiers = {});
    QImage painted() const;
};

inline void SurfaceCurveFixture::init()
{
    QVERIFY(VtkView::openGlAvailable());
    m_viewport = std::make_unique<Viewport>();
    m_viewport->resize(800, 600);
    m_viewport->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get()));
    m_figure = m_viewport->addFigure(tube());
    m_viewport->setPositions(m_figure, tubePositions());
    Turntable camera;
    camera.target = {0, 0, 0};
    camera.yaw = 0;
    camera.pitch = 0;
    camera.distance = 6;
    m_viewport->setCamera(camera);
    m_editor = std::make_unique<SurfaceCurveEditor>(*m_viewport);
    m_editor->setFigure(m_figure);
    m_added.clear();
    connect(m_editor.get(), &SurfaceCurveEditor::pointAdded, this,
            [this](const SurfacePlace& place) { m_added.push_back(place); });
    m_viewport->setViewTool(m_editor.get());
    m_viewport->view()->setFocus();
}

inline void SurfaceCurveFixture::cleanup()
{
    m_editor.reset();
    m_viewport.reset();
}

inline QPoint SurfaceCurveFixture::pixel(std::uint32_t vertex) const
{
    const auto shape = m_viewport->figureShape(m_figure);
    QPointF at;
    m_viewport->camera().project(shape->place(vertex), m_viewport->view()->size(), &at);
    return at.toPoint();
}

inline void SurfaceCurveFixture::mouse(QEvent::Type type, const QPoint& at, Qt::KeyboardModifiers modifiers,
                                       Qt::MouseButton button)
{
    QWidget* view = m_viewport->view();
    const bool isRelease = type == QEvent::MouseButtonRelease;
    const Qt::MouseButtons buttons = isRelease ? Qt::NoButton : Qt::MouseButtons(button);
    QMouseEvent event(type, at, view->mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : button,
                      buttons, modifiers);
    QApplication::sendEvent(view, &event);
}

inline void SurfaceCurveFixture::click(const QPoint& at, Qt::KeyboardModifiers modifiers)
{
    QTest::mouseMove(m_viewport->view(), at);
    mouse(QEvent::MouseButtonPress, at, modifiers);
    mouse(QEvent::MouseButtonRelease, at, modifiers);
}

inline void SurfaceCurveFixture::key(int code, Qt::KeyboardModifiers modifiers)
{
    QTest::keyClick(m_viewport->view(), static_cast<Qt::Key>(code), modifiers);
}

inline QImage SurfaceCurveFixture::painted() const
{
    QImage picture(m_viewport->view()->size(), QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    m_editor->paint(painter);
    return picture;
}

} // namespace quadrille::test

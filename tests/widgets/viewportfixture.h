// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/viewport.h"
#include "widgets/viewport/vtkview.h"

#include <QApplication>
#include <QTest>
#include <memory>
#include <vector>

namespace quadrille::test {

using namespace quadrille::widgets;

/// A square of two metres in the plane z = 0, facing +z.
inline FigureMesh square()
{
    return {.vertexCount = 4,
            .triangles = {{0, 1, 2}, {0, 2, 3}},
            .uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
            .triangleUvs = {{0, 1, 2}, {0, 2, 3}},
            .triangleMaterials = {}};
}

inline std::vector<float> corners(float z = 0)
{
    return {-1, 0, z, 1, 0, z, 1, 2, z, -1, 2, z};
}

inline QImage filled(const QColor& color)
{
    QImage image(16, 16, QImage::Format_RGBA8888);
    image.fill(color);
    return image;
}

/// A view without figures that looks at a square from the front.
class ViewportFixture : public QObject
{
    Q_OBJECT
protected slots:
    void init();
    void cleanup();

protected:
    std::unique_ptr<Viewport> m_viewport;
    int addSquare(const QColor& texture);
    QColor centre();
};

inline void ViewportFixture::init()
{
    QVERIFY(VtkView::openGlAvailable());
    m_viewport = std::make_unique<Viewport>();
    m_viewport->resize(400, 300);
    m_viewport->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_viewport.get()));
    Turntable camera;
    camera.target = {0, 1, 0};
    camera.yaw = 0;
    camera.pitch = 0;
    camera.distance = 8;
    m_viewport->setCamera(camera);
}

inline void ViewportFixture::cleanup()
{
    m_viewport.reset();
}

inline int ViewportFixture::addSquare(const QColor& texture)
{
    const int figure = m_viewport->addFigure(square(), "square");
    m_viewport->setPositions(figure, corners());
    m_viewport->setTexture(figure, filled(texture));
    return figure;
}

inline QColor ViewportFixture::centre()
{
    QTest::qWait(50);
    const QImage image = m_viewport->snapshot();
    return image.isNull() ? QColor() : image.pixelColor(image.rect().center());
}

} // namespace quadrille::test

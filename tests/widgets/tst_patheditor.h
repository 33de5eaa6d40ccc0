// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/patheditor.h"
#include "widgets/tools/pathgeometry.h"
#include "widgets/viewport/scenemarks.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/vtkview.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <memory>

using namespace quadrille::widgets;
using Part = PathPart::Kind;

class TestPathEditor : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void threeClicksDrawAPath();
    void theCurveIsPreviewedToThePointer();
    void aStrokeBecomesFewPoints();
    void aDoubleClickEndsDrawing();
    void aClickOnTheFirstPointClosesThePath();
    void draggingAPointMovesItAndCommitsOnce();
    void escapeTakesADragBack();
    void shiftKeepsToAnAxisAndCtrlSnapsToTheGrid();
    void draggingNothingTurnsTheCamera();
    void handlesMirrorUnlessAltIsHeld();
    void pullingDrawsBezierHandles();
    void aDoubleClickOnTheCurveInsertsAPoint();
    void deleteRemovesAPointAndAtLastThePath();
    void everythingCanBeDoneByKeyboard();
    void stepsAreThoseOfTheRuler_data();
    void stepsAreThoseOfTheRuler();
    void lengthsAreReadInTheirUnits();
    void pointsInSpaceAreLiftedByTheirArrow();
    void endsOfStretchesAreDraggedAlongTheCurve();
    void discsAreDrawnMovedResizedAndDeleted();
    void polygonsAreDrawnCornerByCorner();
    void measuringHasPrecedence();
    void wordsKeepClearOfHandles();
    void dividingABezierKeepsItsForm();
    void polygonsAreTriangulatedAndHatchedInside();

private:
    std::unique_ptr<Viewport> m_viewport;
    std::unique_ptr<PathEditor> m_editor;
    int m_edits = 0;    ///< committed
    int m_previews = 0; ///< not committed
    void show(PathShape shape);
    void showLine(PathKind kind = PathKind::Polyline, bool inSpace = false);
    QPoint pixel(const QVector3D& place) const;
    QPoint pixel(const PathPart& part) const;
    void mouse(QEvent::Type type, const QPoint& at, Qt::KeyboardModifiers modifiers = {},
               Qt::MouseButton button = Qt::LeftButton);
    void click(const QVector3D& place);
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {});
    void key(int code, Qt::KeyboardModifiers modifiers = {});
};

inline constexpr float nearby = 0.03F; // metres; a pixel is some 0.013 here, and clicks fall on whole ones

inline std::vector<QVector3D> sample(PathKind kind, const std::vector<QVector3D>& points)
{
    constexpr int steps = 20;
    std::vector<QVector3D> samples{points.front()};
    const std::size_t stride = kind == PathKind::Bezier ? 3 : 1;
    for (std::size_t i = 0; i + stride < points.size(); i += stride) {
        for (int step = 1; step <= steps; ++step) {
            const float t = static_cast<float>(step) / steps;
            const float s = 1.0F - t;
            samples.push_back(kind == PathKind::Bezier
                                  ? s * s * s * points[i] + 3 * s * s * t * points[i + 1] +
                                        3 * s * t * t * points[i + 2] + t * t * t * points[i + 3]
                                  : s * points[i] + t * points[i + 1]);
        }
        samples.back() = points[i + stride];
    }
    return samples;
}

inline bool isNear(const QVector3D& a, const QVector3D& b)
{
    return (a - b).length() < nearby;
}

#define VERIFY_NEAR(actual, ...)                                                                             \
    do {                                                                                                     \
        const QVector3D is = (actual);                                                                       \
        QVERIFY2(isNear(is, __VA_ARGS__),                                                                    \
                 qPrintable(QStringLiteral("%1 %2 %3").arg(is.x()).arg(is.y()).arg(is.z())));                \
    } while (false)

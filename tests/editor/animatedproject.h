// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/context/editorcontext.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "model/project/results/openanimation.h"

#include <QDir>
#include <cmath>
#include <numbers>

namespace quadrille::test {

/// A spire of three rings that sways and turns, in takes that are much alike: transitions are everywhere.
inline void writeSwaying(const QString& folder, int frames, double phase)
{
    QDir().mkpath(folder);
    for (int f = 0; f < frames; ++f) {
        std::ofstream file(
            QStringLiteral("%1/m_%2.obj").arg(folder).arg(f, 3, 10, QLatin1Char('0')).toStdString());
        const double sway = 0.4 * std::sin(2 * std::numbers::pi * f / 24 + phase);
        for (int ring = 0; ring < 3; ++ring) {
            const double lean = sway * ring * ring / 2;
            for (int corner = 0; corner < 4; ++corner) {
                const double angle = std::numbers::pi * corner / 2 + 0.3 * lean * ring;
                const double radius = 0.4 - 0.1 * ring + (corner == 0 ? 0.1 : 0);
                file << "v " << radius * std::cos(angle) + lean << ' ' << 0.8 * ring << ' '
                     << radius * std::sin(angle) + 0.02 * f << '\n';
            }
        }
        for (int ring = 0; ring < 2; ++ring) {
            for (int corner = 0; corner < 4; ++corner) {
                const int a = 4 * ring + corner + 1;
                const int b = 4 * ring + (corner + 1) % 4 + 1;
                file << "f " << a << ' ' << a + 4 << ' ' << b << "\nf " << b << ' ' << a + 4 << ' ' << b + 4
                     << '\n';
            }
        }
    }
}

/// A project of three such takes, with an animation "dance" that performs a part of each of the first two.
inline Project swayingProject(const QString& folder)
{
    Project project;
    const auto path = [&](const char* name) { return QDir(folder).filePath(name).toStdString(); };
    project.characters = {{.name = "spire", .mesh = path("first/m_000.obj")}};
    for (const char* name : {"first", "second", "third"})
        project.sequences.push_back({.name = name, .character = "spire", .source = path(name)});
    AnimationEntry dance{.name = "dance", .character = "spire"};
    const auto part = [](const char* sequence, int from, int to) {
        return ActionEntry{.frames = {.label = {},
                                      .sequence = sequence,
                                      .range = FrameRange{FrameIndex(from), FrameIndex(to)}}};
    };
    dance.constraints = {part("first", 4, 20), part("second", 20, 40)};
    dance.search.budget = 20'000;
    project.animations = {dance};
    return project;
}

inline void writeSwayingTakes(const QString& folder)
{
    writeSwaying(QDir(folder).filePath("first"), 60, 0);
    writeSwaying(QDir(folder).filePath("second"), 60, 0.7);
    writeSwaying(QDir(folder).filePath("third"), 60, 1.9);
}

/// A window with that project, in the Animate workspace with “dance”.
inline std::unique_ptr<MainWindow> openAnimated(const QString& folder)
{
    auto window = std::make_unique<MainWindow>();
    window->resize(1000, 700);
    window->show();
    if (!QTest::qWaitForWindowExposed(window.get()))
        return nullptr;
    window->context().document.reset(swayingProject(folder));
    window->context().selection.selectAnimations({"dance"});
    window->workspaces().select("animate");
    return window;
}

/// Waits until the last word on an animation as it is now was spoken.
inline bool waitForResult(EditorContext& context, const QString& name)
{
    return QTest::qWaitFor(
        [&] {
            const auto* resultState = context.animations.resultState(name);
            return resultState != nullptr && resultState->phase == ResultPhase::Ready &&
                   resultState->result->entry == *context.document.animation(name);
        },
        patience);
}

} // namespace quadrille::test

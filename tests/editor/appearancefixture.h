// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/context/editorcontext.h"
#include "editor/workspaces/appearance/appearanceworkspace.h"
#include "editor/workspaces/appearance/currentappearance.h"
#include "editor/workspaces/appearance/showntexture.h"
#include "editor/workspaces/appearance/texturecomparison.h"
#include "editor/workspaces/workspacetabs.h"
#include "editortest.h"
#include "widgets/controls/comparedview.h"

#include <QAction>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QToolButton>
#include <cmath>
#include <memory>

namespace quadrille {

/// The window with two takes of a strip whose texture moves as it bends, and a small model of it.
class AppearanceFixture : public QObject
{
    Q_OBJECT

protected:
    static constexpr int frames = 9;
    static constexpr int side = 64; ///< of textures

    EditorContext& context() { return m_window->context(); }
    ProjectDocument& document() { return context().document; }
    AppearanceWorkspace& workspace() { return m_window->appearance(); }
    ShownTexture& shown() { return workspace().shown(); }
    const ShownPair& pair() { return workspace().comparison().pair(); }
    widgets::ComparedView& view() { return workspace().comparison().view(); }
    const AppearanceEntry& entry() { return document().project().appearances.front(); }
    QAction* action(const char* id) { return context().actions.action(QLatin1String(id)); }
    void press(const char* id)
    {
        QTest::mouseClick(test::find<QToolButton>(QLatin1String(id)), Qt::LeftButton);
    }
    template <typename Widget>
    Widget* find(const char* name)
    {
        return test::find<Widget>(QLatin1String(name));
    }
    ResultPhase phase()
    {
        const auto* state = workspace().appearance().resultState();
        return state == nullptr ? ResultPhase::Idle : state->phase;
    }

    /// A grey pattern of some waves, moved to the left.
    static QImage pattern(double shift)
    {
        QImage image(side, side, QImage::Format_RGB32);
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const double at = x + shift;
                const double grey = 120 + 45 * std::sin(0.31 * at + 0.17 * y) +
                                    35 * std::sin(0.23 * y - 0.12 * at) + 25 * std::sin(0.55 * at - 0.4 * y);
                const int level = static_cast<int>(std::lround(std::clamp(grey, 0.0, 255.0)));
                image.setPixel(x, y, qRgb(level, level, level));
            }
        }
        return image;
    }
    void writeTake(const QString& name, double pace)
    {
        const QDir folder(m_folder->path());
        folder.mkpath(name);
        folder.mkpath("looks/" + name);
        for (int f = 0; f < frames; ++f) {
            const double bend = std::sin(pace * f);
            std::ofstream file(folder.filePath(QStringLiteral("%1/f_%2.obj").arg(name).arg(f)).toStdString());
            for (int row = 0; row < 5; ++row)
                file << "v " << row << ' ' << 0.2 * bend * row * row << " 0\nv " << row << ' '
                     << 0.2 * bend * row * row << " 1\n";
            for (int row = 0; row < 5; ++row)
                file << "vt " << 4 / 64.0 << ' ' << (4 + 14 * row) / 64.0 << "\nvt " << 60 / 64.0 << ' '
                     << (4 + 14 * row) / 64.0 << '\n';
            for (int a = 1; a < 8; a += 2)
                file << "f " << a << '/' << a << ' ' << a + 1 << '/' << a + 1 << ' ' << a + 3 << '/' << a + 3
                     << "\nf " << a << '/' << a << ' ' << a + 3 << '/' << a + 3 << ' ' << a + 2 << '/'
                     << a + 2 << '\n';
            pattern(2.5 * bend)
                .save(folder.filePath(
                    QStringLiteral("looks/%1/%2.png").arg(name).arg(f, 4, 10, QLatin1Char('0'))));
        }
    }
    Project project(bool hasTextures = true)
    {
        Project project;
        const QDir folder(m_folder->path());
        for (const char* name : {"slow", "quick"}) {
            SequenceEntry take{.name = name, .source = folder.filePath(name).toStdString()};
            if (hasTextures)
                take.texture = {TextureReference::Kind::PerFrame,
                                {folder.filePath(QStringLiteral("looks/") + name).toStdString()}};
            project.sequences.push_back(take);
        }
        return project;
    }
    Project modelled()
    {
        Project with = project();
        with.appearances = {{.name = "look", .components = 6, .flow = FlowMethod::Dis}};
        return with;
    }
    void open(Project project)
    {
        document().reset(std::move(project));
        m_window->workspaces().select("appearance");
        QVERIFY(test::waitForSequence(*m_window, "slow"));
        QVERIFY(test::waitForSequence(*m_window, "quick"));
        QTRY_COMPARE(workspace().scene().frameCount(), std::int64_t{frames});
    }
    /// By the button of the bar.
    void build()
    {
        open(modelled());
        QTRY_COMPARE(phase(), ResultPhase::Stale);
        press("tool.appearance.build");
        QTRY_COMPARE(phase(), ResultPhase::Ready);
        QTRY_VERIFY(pair().quality.has_value());
    }

protected slots:
    void initTestCase() { test::isolate(); }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        writeTake("slow", 0.35);
        writeTake("quick", 0.7);
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1000, 700);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QVERIFY(test::activate(*m_window));
    }
    void cleanup()
    {
        document().undoStack()->setClean();
        m_window.reset();
        m_folder.reset();
    }

protected:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The pictures of the manual: made here from the sample, and compared with those that the manual has, so that
// they cannot go stale. With QUADRILLE_PICTURES set to a folder they are written there (./dev pictures).
#include "editor/commands/appearanceedits.h"
#include "editor/docks/cardpictures.h"
#include "editor/docks/sequencecards.h"
#include "editor/playback/player.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/appearance/appearanceworkspace.h"
#include "editor/workspaces/appearance/currentappearance.h"
#include "editor/workspaces/appearance/texturecomparison.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "editor/workspaces/graph/graphmap.h"
#include "editor/workspaces/graph/graphworkspace.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editor/workspaces/variations/bodysurface.h"
#include "editor/workspaces/variations/partcurvetool.h"
#include "editor/workspaces/workspacetabs.h"
#include "model/sample/sample.h"
#include "tests/qt/registry.h"
#include "variedproject.h"
#include "widgets/graph/matrixview.h"
#include "widgets/theme/theme.h"

#include <QDockWidget>
#include <QImage>
#include <filesystem>
#include <memory>

namespace quadrille {

namespace {

constexpr QSize windowSize(1280, 800);
constexpr QSize comparedSize(32, 20);

/// Mean difference of two pictures seen from afar, 0 … 255. Fonts and edges differ from machine to machine,
/// panels and figures do not.
double difference(const QImage& a, const QImage& b)
{
    const auto small = [](const QImage& image) {
        return image.scaled(comparedSize, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
            .convertToFormat(QImage::Format_RGB888);
    };
    const QImage first = small(a);
    const QImage second = small(b);
    double sum = 0;
    for (int y = 0; y < comparedSize.height(); ++y) {
        for (int x = 0; x < 3 * comparedSize.width(); ++x)
            sum += std::abs(first.constScanLine(y)[x] - second.constScanLine(y)[x]);
    }
    return sum / (3.0 * comparedSize.width() * comparedSize.height());
}

} // namespace

class ManualTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }

    /// Compares the window with a picture of the manual, or writes it.
    void keep(const QString& name)
    {
        QTRY_VERIFY(context().jobs.jobs().empty());
        QTest::qWait(200); // what was computed last is drawn
        const QImage picture = m_window->grab().toImage();
        QVERIFY(!picture.isNull());
        const QString folder = qEnvironmentVariable("QUADRILLE_PICTURES");
        if (!folder.isEmpty()) {
            QVERIFY(picture.save(QDir(folder).filePath(name + ".png")));
            return;
        }
        const QImage kept(":/help/pictures/" + name + ".png");
        QVERIFY2(!kept.isNull(), qPrintable("the manual has no picture " + name + ": run ./dev pictures"));
        constexpr double tolerance = 12; // of 255; another panel in front is more, other fonts are less
        const double found = difference(picture, kept);
        if (found > tolerance)
            picture.save(name + "-now.png");
        QVERIFY2(found <= tolerance,
                 qPrintable(QStringLiteral("%1.png of the manual is out of date (%2 of 255): run "
                                           "./dev pictures; the picture of now is beside the test")
                                .arg(name)
                                .arg(found)));
    }
    void showAnimation(const QString& name)
    {
        m_window->workspaces().select("animate");
        context().selection.selectAnimations({name});
        QVERIFY(test::waitForResult(context(), name));
        QTRY_VERIFY(m_window->animate().scene().frameCount() > 0);
        m_window->animate().player().goTo(m_window->animate().scene().frameCount() / 2);
        m_window->animate().viewport().frameAll();
    }

    /// The sample with its results where another test left it, or else without.
    std::filesystem::path sampleProject() const
    {
        const std::filesystem::path sample = m_folder.filePath("sample").toStdString();
        if (m_rebuilt.isEmpty())
            return writeSample(sample);
        std::filesystem::copy(m_rebuilt.toStdString(), sample, std::filesystem::copy_options::recursive);
        return sample / "sample.quadrille";
    }

    QTemporaryDir m_folder;
    QString m_rebuilt = qEnvironmentVariable("QUADRILLE_REBUILT_SAMPLE");
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        widgets::Theme::instance().install();
        widgets::Theme::instance().setMode(widgets::Theme::Mode::Light);
        const std::filesystem::path project = sampleProject();
        m_window = std::make_unique<MainWindow>();
        m_window->resize(windowSize);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->open({QString::fromStdString(project.string())});
        for (const SequenceEntry& entry : context().document.project().sequences)
            QVERIFY(test::waitForSequence(*m_window, QString::fromStdString(entry.name)));
        QTRY_VERIFY(m_window->sequences().player().isPlaying());
        m_window->sequences().player().pause();
    }
    void cleanupTestCase() { m_window.reset(); }

    void sequences()
    {
        m_window->sequences().player().goTo(12);
        m_window->sequences().viewport().frameAll();
        const CardPictures& pictures = m_window->findChild<SequenceCards*>()->pictures();
        QTRY_VERIFY(pictures.countOf("right turn 2") > 0);
        keep("sequences");
    }

    void graph()
    {
        const QString character = context().graphs.firstCharacter();
        context().graphs.ask(character);
        QTRY_VERIFY(context().graphs.resultState(character)->phase == ResultPhase::Ready);
        m_window->workspaces().select("graph");
        GraphWorkspace& workspace = m_window->graph();
        QTRY_VERIFY(workspace.explorer().measured() != nullptr);
        // The map is drawn after its character is there, and takes no keys before.
        const FrameLayout& layout = workspace.explorer().character()->graph.layout();
        QTRY_VERIFY(workspace.map().matrix().values().side == layout.frameCount());
        const Digraph& graph = workspace.explorer().graphs()->essential;
        const auto isFar = [](const Edge& edge) {
            return edge.kind == EdgeKind::Transition && edge.to > edge.from + 200;
        };
        const auto edge = std::ranges::find_if(graph.edges(), isFar);
        QVERIFY(edge != graph.edges().end());
        workspace.map().matrix().setCurrentCell(widgets::MatrixCell{edge->from, edge->to});
        QTest::keyClick(&workspace.map().matrix(), Qt::Key_Return);
        QTRY_VERIFY(workspace.scene().frameCount() > 1);
        workspace.player().pause();
        workspace.player().goTo(workspace.scene().frameCount() / 2);
        keep("graph");
    }

    void animate()
    {
        showAnimation("along an S");
        keep("animate");
    }

    void keys()
    {
        showAnimation("dance by the clock");
        keep("keys");
    }

    void storyboard()
    {
        showAnimation("walk, kick, jump");
        test::find<QDockWidget>("storyboardDock")->show();
        keep("storyboard");
    }

    void variations()
    {
        m_window->workspaces().select("variations");
        context().selection.select({Section::Variations, "walking"});
        if (m_rebuilt.isEmpty()) {
            QVERIFY(test::waitForState(context(), "walking", test::isNotLearned));
            context().actions.action("variations.learn")->trigger();
        }
        QVERIFY(test::waitForVariations(context(), "walking"));
        Workspace::showPanel(test::find<QWidget>("samplesPanel"));
        VariationsWorkspace& workspace = m_window->variations();
        QTRY_COMPARE(workspace.scene().shown().size(), 5);
        workspace.player().pause();
        workspace.player().goTo(workspace.scene().frameCount() / 2);
        workspace.viewport().frameAll();
        keep("variations");
    }

    void bodyParts()
    {
        m_window->workspaces().select("variations");
        Workspace::showPanel(test::find<QWidget>("bodyPartsPanel"));
        QTRY_VERIFY(m_window->variations().parts().editor().isActive());
        QTRY_VERIFY(m_window->variations().parts().surface().graph() != nullptr);
        m_window->variations().viewport().frameAll();
        keep("body-parts");
    }

    void appearance()
    {
        addAppearance(context().document, {.name = "look",
                                           .character = "Quad",
                                           .sequences = {"walk 1", "idle 1"},
                                           .components = 20,
                                           .flow = FlowMethod::Dis,
                                           .reference = NamedFrame{"walk 1", FrameIndex(20)}});
        m_window->workspaces().select("appearance");
        context().selection.select({Section::Appearances, "look"});
        AppearanceWorkspace& workspace = m_window->appearance();
        const auto state = [&] { return workspace.appearance().resultState(); };
        QTRY_VERIFY(state() != nullptr && state()->phase == ResultPhase::Stale);
        context().actions.action("appearance.build")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(state()->phase == ResultPhase::Ready, 300'000);
        context().selection.selectSequences({"walk 1"});
        QTRY_VERIFY(workspace.scene().frameCount() > 12);
        workspace.player().pause();
        workspace.player().goTo(12);
        workspace.viewport().frameAll();
        QTRY_VERIFY(workspace.comparison().pair().quality.has_value());
        keep("appearance");
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::ManualTest);
#include "tst_manual.moc"

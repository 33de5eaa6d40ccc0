// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The texture dock, with a small project of sequences that have textures of each kind, or none.
#include "editor/commands/projectedits.h"
#include "editor/fields/texturefield.h"
#include "editor/playback/clipscene.h"
#include "editor/playback/player.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editortest.h"
#include "tests/qt/registry.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/controls/textureview.h"
#include "widgets/viewport/viewport.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

namespace quadrille {

namespace {

constexpr int frames = 12;

/// Triangles with materials "left", "right" and "top", in some frames.
void writeMesh(const QString& folder, bool hasUvs)
{
    QDir().mkpath(folder);
    for (int f = 0; f < frames; ++f) {
        std::ofstream file(QStringLiteral("%1/m_%2.obj").arg(folder).arg(f).toStdString());
        file << "v 0 " << 0.1 * f << " 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
        if (hasUvs)
            file
                << "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl left\nf 1/1 2/2 3/3\nusemtl right\nf 1/1 3/3 4/4\n"
                   "usemtl top\nf 1/1 2/2 4/4\n";
        else
            file << "f 1 2 3\nf 1 3 4\n";
    }
}

void writePicture(const QString& file, const QColor& color, int size = 8)
{
    QImage image(size, size, QImage::Format_RGB888);
    image.fill(color);
    QVERIFY(image.save(file));
}

} // namespace

class TexturePanelTest : public QObject
{
    Q_OBJECT

private:
    EditorContext& context() { return m_window->context(); }
    widgets::TextureView& view() { return *test::find<widgets::TextureView>("textureView"); }
    QString path(const char* name) { return m_folder.filePath(name); }
    QString text(const char* label) { return test::find<QWidget>(label)->property("text").toString(); }
    QString emptyText() { return text("textureViewEmpty"); }
    QColor color() { return view().image().isNull() ? QColor() : view().image().pixelColor(4, 4); }
    void show(const QString& name)
    {
        context().selection.selectSequences({name});
        QVERIFY(test::waitForSequence(*m_window, name));
        QVERIFY(test::activate(*m_window));
        m_window->sequences().viewport().setFocus();
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        test::isolate();
        writeMesh(path("mesh"), true);
        writeMesh(path("bare"), false);
        QDir().mkpath(path("changing"));
        QDir().mkpath(path("broken"));
        for (int f = 0; f < frames; ++f) {
            writePicture(path("changing") + QStringLiteral("/t_%1.png").arg(f), QColor(20 * f, 0, 0));
            writePicture(path("broken") + QStringLiteral("/b_%1.png").arg(f), Qt::blue);
        }
        std::ofstream(path("broken/b_3.png").toStdString()) << "no picture";
        writePicture(path("green.png"), Qt::green, 300);
        writePicture(path("yellow.png"), Qt::yellow, 16);
        writePicture(path("red.png"), Qt::red, 16);
    }

    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        using Kind = TextureReference::Kind;
        const auto at = [this](const char* name) { return path(name).toStdString(); };
        const auto sequence = [&](const char* name, const char* source, TextureReference texture) {
            return SequenceEntry{
                .name = name, .character = source, .source = at(source), .texture = std::move(texture)};
        };
        Project project;
        project.characters = {{.name = "mesh", .mesh = at("mesh/m_0.obj")},
                              {.name = "bare", .mesh = at("bare/m_0.obj")}};
        project.sequences = {
            sequence("changing", "mesh", {Kind::PerFrame, {at("changing")}, {}}),
            sequence("single", "mesh", {Kind::Single, {at("green.png")}, {}}),
            sequence("parts", "mesh",
                     {Kind::PerMaterial, {at("green.png"), at("yellow.png"), at("red.png")}, {}}),
            sequence("broken", "mesh", {Kind::PerFrame, {at("broken")}, {}}),
            sequence("untextured", "mesh", {}),
            sequence("bare", "bare", {}),
            sequence("useless", "bare", {Kind::Single, {at("green.png")}, {}})};
        context().document.reset(project);
        test::find<QDockWidget>("textureDock")->toggleViewAction()->trigger();
        QTRY_VERIFY(view().isVisible());
    }

    void cleanup()
    {
        context().document.reset({});
        m_window.reset();
    }

    void isHiddenAtFirstAndFoundByName()
    {
        auto* dock = test::find<QDockWidget>("textureDock");
        dock->toggleViewAction()->trigger();
        QVERIFY(!dock->isVisible());
        QVERIFY(test::activate(*m_window));
        QTest::keyClick(m_window.get(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        auto* field = test::find<QLineEdit>("actionPaletteField");
        QTRY_VERIFY(field->isVisible());
        QTest::keyClicks(field, "texture");
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY(dock->isVisible());
    }

    void followsTheTimeline()
    {
        show("changing");
        QTRY_COMPARE(text("textureFile"), QString("t_0.png"));
        QCOMPARE(text("textureFacts"), QString("8 × 8 pixels · frame 0"));
        QTest::keyClick(m_window.get(), Qt::Key_Right);
        QTRY_COMPARE(color(), QColor(20, 0, 0));
        QTest::keyClick(m_window.get(), Qt::Key_End);
        QTRY_COMPARE(color(), QColor(20 * (frames - 1), 0, 0));
        QCOMPARE(text("textureFile"), QString("t_11.png"));
        QCOMPARE(text("textureFacts"), QString("8 × 8 pixels · frame 11"));
        QTest::keyClick(m_window.get(), Qt::Key_Home);
        QTRY_COMPARE(color(), QColor(0, 0, 0));
        // Playing, pictures come and go, and at the end it is the one of the frame that is shown.
        int pictures = 0;
        QColor last = color();
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(([&] {
            pictures += color() == last ? 0 : 1;
            last = color();
            return pictures >= 3;
        })());
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_COMPARE(color().red(), static_cast<int>(20 * m_window->sequences().player().frame().value));
    }

    void restsWhileHiddenAndCatchesUp()
    {
        show("changing");
        QTRY_COMPARE(color(), QColor(0, 0, 0));
        auto* dock = test::find<QDockWidget>("textureDock");
        dock->close();
        QTest::keyClick(m_window.get(), Qt::Key_End);
        QTRY_COMPARE(m_window->sequences().scene().textureOf("changing").pixelColor(4, 4).red(), 220);
        QCOMPARE(color(), QColor(0, 0, 0));
        dock->show();
        QTRY_COMPARE(color(), QColor(220, 0, 0));
    }

    void zoomsAndTellsThePlaceUnderThePointer()
    {
        show("single");
        QTRY_COMPARE(color(), QColor(Qt::green));
        QCOMPARE(text("textureFacts"), QString("300 × 300 pixels · all frames"));
        const QPoint place = view().positionOf({0.25, 0.75}).toPoint();
        QTest::mouseMove(&view(), place);
        const auto told = [&] {
            const QPoint pixel = view().pixelAt(place);
            return text("texturePointer")
                .endsWith(QStringLiteral("pixel %1, %2").arg(pixel.x()).arg(pixel.y()));
        };
        QTRY_VERIFY(told());
        QVERIFY(text("texturePointer").startsWith("u 0.2"));
        QTest::mouseClick(test::find<QToolButton>("textureActualSize"), Qt::LeftButton);
        QCOMPARE(view().zoom(), 1.0);
        QCOMPARE(text("textureZoom"), QString("100 %"));
        // F fits the texture while it has the keyboard, and does not frame the figure.
        QTest::mouseClick(&view(), Qt::LeftButton);
        const auto camera = m_window->sequences().viewport().camera();
        QTest::keyClick(&view(), Qt::Key_F);
        QVERIFY(view().isFitted());
        QVERIFY(m_window->sequences().viewport().camera() == camera);
        // An arrow steps as long as there is nothing to move.
        QTest::keyClick(&view(), Qt::Key_Right);
        QTRY_COMPARE(m_window->sequences().player().frame(), FrameIndex(1));
    }

    void drawsEachEdgeOnce()
    {
        show("changing");
        QTRY_COMPARE(color(), QColor(0, 0, 0));
        auto* check = test::find<QCheckBox>("textureEdges");
        QVERIFY(view().uvEdges().isEmpty());
        QTest::mouseClick(check, Qt::LeftButton, {}, {8, check->height() / 2});
        QTRY_COMPARE(view().uvEdges().size(), 6);
        QVERIFY(view().uvEdges().contains(QLineF(0, 0, 1, 1)));
        show("bare");
        QTRY_VERIFY(view().uvEdges().isEmpty());
        QVERIFY(!check->isEnabled());
        show("untextured");
        QTRY_COMPARE(view().uvEdges().size(), 6);
        // There is something to see, so what is missing is said above it.
        auto* note = test::find<widgets::MessageStrip>("textureNote");
        QTRY_VERIFY(note->isVisible());
        QVERIFY(note->text().contains("has no texture"));
        QTest::mouseClick(note->findChild<QPushButton*>("messageStripAction"), Qt::LeftButton);
        QMenu* menu = test::find<TextureField>("textureChoice")->menu();
        QTRY_VERIFY(menu->isVisible());
        menu->close();
        QTest::mouseClick(check, Qt::LeftButton, {}, {8, check->height() / 2});
        QTRY_VERIFY(view().isEmpty());
        QVERIFY(!note->isVisible());
    }

    void choosesAMaterial()
    {
        auto* materials = test::find<QComboBox>("textureMaterial");
        show("changing");
        QTRY_COMPARE(color(), QColor(0, 0, 0));
        QVERIFY(!materials->isVisible());
        show("parts");
        QTRY_COMPARE(color(), QColor(Qt::green));
        QVERIFY(materials->isVisible());
        QCOMPARE(materials->count(), 3);
        test::find<QCheckBox>("textureEdges")->click();
        materials->setFocus();
        QTest::keyClick(materials, Qt::Key_Down);
        QCOMPARE(materials->currentText(), QString("right"));
        QTRY_COMPARE(color(), QColor(Qt::yellow));
        QCOMPARE(text("textureFile"), QString("yellow.png"));
        QTRY_COMPARE(view().uvEdges().size(), 3);
        QVERIFY(view().uvEdges().contains(QLineF(0, 0, 0, 1)));
        // However quickly one is chosen after the other, the last one stays.
        QTest::keyClick(materials, Qt::Key_Up);
        QTest::keyClick(materials, Qt::Key_Down);
        QTest::keyClick(materials, Qt::Key_Down);
        QTRY_COMPARE(color(), QColor(Qt::red));
        QCOMPARE(text("textureFile"), QString("red.png"));
    }

    void saysWhatIsMissingAndOffersToChoose()
    {
        auto* choice = test::find<TextureField>("textureChoice");
        show("untextured");
        QTRY_VERIFY(emptyText().contains("“untextured” has no texture."));
        QTRY_VERIFY(choice->isVisible());
        QVERIFY(!test::find<QToolButton>("textureFit")->isVisible());
        emit choice->chosen({TextureReference::Kind::Single, {path("yellow.png").toStdString()}, {}});
        QTRY_COMPARE(color(), QColor(Qt::yellow));
        QVERIFY(!choice->isVisible());
        context().document.undo();
        QTRY_VERIFY(view().isEmpty() && choice->isVisible());
        show("bare");
        QTRY_VERIFY(emptyText().contains("no texture coordinates"));
        // A texture that cannot be put on is shown all the same, and so is why.
        show("useless");
        QTRY_COMPARE(color(), QColor(Qt::green));
        auto* note = test::find<widgets::MessageStrip>("textureNote");
        QTRY_VERIFY(note->isVisible());
        QVERIFY(note->text().contains("no texture coordinates"));
    }

    void saysWhichPictureCannotBeRead()
    {
        show("broken");
        QTRY_COMPARE(color(), QColor(Qt::blue));
        m_window->sequences().player().goTo(3);
        QTRY_VERIFY(view().isEmpty());
        QVERIFY2(emptyText().contains("b_3.png"), qPrintable(emptyText()));
        m_window->sequences().player().goTo(4);
        QTRY_COMPARE(color(), QColor(Qt::blue));
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST(quadrille::TexturePanelTest);
#include "tst_texturepanel.moc"

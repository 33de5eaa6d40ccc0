// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/projectedits.h"
#include "editor/commands/variationedits.h"
#include "editor/documents/sequencemedia.h"
#include "editor/jobs/jobrunner.h"
#include "tests/qt/registry.h"

#include <QSignalSpy>
#include <QTest>

namespace quadrille {

namespace {

Project exampleProject()
{
    Project project;
    project.settings.fps = 30;
    project.characters.resize(2);
    project.characters[0].name = "Ada";
    project.characters[0].mesh = "/data/ada.obj";
    project.characters[0].notes = "tall";
    project.characters[1].name = "Bo";
    project.characters[1].mesh = "/data/bo.obj";
    project.sequences = {
        {.name = "walk", .character = "Ada", .source = "/data/walk.pc2"},
        {.name = "jump",
         .character = "Ada",
         .source = "/data/jump.pc2",
         .range = FrameRange{FrameIndex(2), FrameIndex(9)}},
        {.name = "kick", .character = "Bo", .source = "/data/kick.pc2"},
    };
    project.exports = {{.name = "for Blender", .what = "sequences/walk", .path = "/out/walk.glb"},
                       {.name = "cache", .what = "sequences/kick", .path = "/out/kick.pc2"}};
    KeyEntry key;
    key.sequence = "jump";
    project.animations = {{.name = "waltz", .character = "Ada", .constraints = {key}}};
    project.variations = {{.name = "strolls", .character = "Ada", .training = {{.sequence = "walk"}}}};
    project.exports.push_back({.name = "dance", .what = "animations/waltz", .path = "/out/waltz.glb"});
    return project;
}

struct Edit
{
    QString text;
    std::function<void(ProjectDocument&)> run;
    std::function<bool(const Project&)> expected;
};

const std::vector<Edit>& edits()
{
    static const FrameRange range{FrameIndex(3), FrameIndex(7)};
    static const TextureReference texture{TextureReference::Kind::Single, {"/data/skin.png"}};
    static const std::vector<Edit> all = {
        {"Add “run”",
         [](auto& d) { addSequences(d, {{.name = "run", .character = "Ada", .source = "/data/run.pc2"}}); },
         [](const Project& p) { return p.sequences.size() == 4 && p.sequences[3].name == "run"; }},
        {"Add 2 sequences",
         [](auto& d) {
             addSequences(d,
                          {{.name = "walk", .character = "Ada", .source = "a"},
                           {.name = "run", .character = "Bo", .source = "b"}},
                          {{.name = "Ada", .mesh = "/data/other.obj"}});
         },
         [](const Project& p) {
             return p.sequences[3].name == "walk 2" && p.sequences[3].character == "Ada 2" &&
                    p.characters[2].name == "Ada 2";
         }},
        {"Remove “walk”", [](auto& d) { removeEntries(d, Section::Sequences, {"walk"}); },
         [](const Project& p) { return p.sequences.size() == 2 && p.exports.size() == 2; }},
        {"Remove 2 sequences",
         [](auto& d) {
             removeEntries(d, Section::Sequences, {"kick", "walk"});
         },
         [](const Project& p) { return p.sequences.size() == 1 && p.exports.size() == 1; }},
        {"Remove “Ada”", [](auto& d) { removeEntries(d, Section::Characters, {"Ada"}); },
         [](const Project& p) {
             return p.characters.size() == 1 && p.sequences.size() == 1 && p.exports.size() == 1;
         }},
        {"Remove “cache”", [](auto& d) { removeEntries(d, Section::Exports, {"cache"}); },
         [](const Project& p) { return p.exports.size() == 2 && p.sequences.size() == 3; }},
        {"Duplicate “walk”", [](auto& d) { duplicateSequence(d, "walk"); },
         [](const Project& p) {
             return p.sequences[1].name == "walk 2" && p.sequences[1].source == "/data/walk.pc2";
         }},
        {"Rename “walk” to “stroll”",
         [](auto& d) {
             renameEntry(d, {Section::Sequences, "walk"}, " stroll ");
         },
         [](const Project& p) {
             return p.sequences[0].name == "stroll" && p.exports[0].what == "sequences/stroll";
         }},
        {"Rename “waltz” to “polka”",
         [](auto& d) {
             renameEntry(d, {Section::Animations, "waltz"}, "polka");
         },
         [](const Project& p) {
             return p.animations[0].name == "polka" && p.exports[2].what == "animations/polka";
         }},
        {"Add variations “strolls 2”",
         [](auto& d) { addVariation(d, {.name = "strolls", .character = "Ada"}); },
         [](const Project& p) { return p.variations.size() == 2 && p.variations[1].name == "strolls 2"; }},
        {"Duplicate “strolls”", [](auto& d) { duplicateVariation(d, "strolls"); },
         [](const Project& p) {
             return p.variations.size() == 2 && p.variations[1].training == p.variations[0].training;
         }},
        {"Change the dimensions",
         [](auto& d) {
             VariationEntry after = *d.variation("strolls");
             after.learning.dimensions = 4;
             setVariation(d, "strolls", "Change the dimensions", "dimensions", after);
         },
         [](const Project& p) { return p.variations[0].learning.dimensions == 4; }},
        {"Rename “strolls” to “walks”",
         [](auto& d) {
             renameEntry(d, {Section::Variations, "strolls"}, "walks");
         },
         [](const Project& p) { return p.variations[0].name == "walks"; }},
        {"Remove “strolls”", [](auto& d) { removeEntries(d, Section::Variations, {"strolls"}); },
         [](const Project& p) { return p.variations.empty(); }},
        {"Draw a curve",
         [](auto& d) {
             BodyPartsEntry body = bodyPartsEntry(d.project(), "Ada");
             body.curves.push_back({.curve = {.name = "neck", .vertices = {VertexIndex(1)}}, .points = {}});
             setBodyParts(d, "Draw a curve", "curve", body);
         },
         [](const Project& p) {
             return p.bodyParts.size() == 1 && p.bodyParts[0].character == "Ada" &&
                    p.bodyParts[0].curves.size() == 1;
         }},
        {"Remove “jump”", [](auto& d) { removeEntries(d, Section::Sequences, {"jump"}); },
         [](const Project& p) { return p.sequences.size() == 2 && p.animations[0].constraints.empty(); }},
        {"Remove “waltz”", [](auto& d) { removeEntries(d, Section::Animations, {"waltz"}); },
         [](const Project& p) { return p.animations.empty() && p.exports.size() == 2; }},
        {"Rename “Ada” to “Eva”",
         [](auto& d) {
             renameEntry(d, {Section::Characters, "Ada"}, "Eva");
         },
         [](const Project& p) { return p.characters[0].name == "Eva" && p.sequences[1].character == "Eva"; }},
        {"Rename “cache” to “PC2”",
         [](auto& d) {
             renameEntry(d, {Section::Exports, "cache"}, "PC2");
         },
         [](const Project& p) { return p.exports[1].name == "PC2"; }},
        {"Trim “walk”", [](auto& d) { setSequenceRange(d, "walk", range); },
         [](const Project& p) { return p.sequences[0].range == range; }},
        {"Change the frame rate of “walk”", [](auto& d) { setSequenceFps(d, "walk", 50); },
         [](const Project& p) { return p.sequences[0].sourceFps == 50; }},
        {"Change axes or unit of “walk”",
         [](auto& d) {
             setSequenceAxes(d, "walk", CoordinateSystem{UpAxis::Z, 0.01});
         },
         [](const Project& p) {
             return p.sequences[0].sourceAxes == CoordinateSystem{UpAxis::Z, 0.01};
         }},
        {"Change the texture of “walk”", [](auto& d) { setSequenceTexture(d, "walk", texture); },
         [](const Project& p) { return p.sequences[0].texture == texture; }},
        {"Change the character of “kick”", [](auto& d) { setSequenceCharacter(d, "kick", "Ada"); },
         [](const Project& p) { return p.sequences[2].character == "Ada"; }},
        {"Label “walk”",
         [](auto& d) {
             setSequenceLabels(d, "walk", {{"step", range}});
         },
         [](const Project& p) {
             return p.sequences[0].labels == std::vector<LabelSpan>{{"step", range}};
         }},
        {"Mark foot contacts of “walk”",
         [](auto& d) {
             setSequenceContacts(d, "walk", {{"left", range}});
         },
         [](const Project& p) {
             return p.sequences[0].contacts == std::vector<ContactSpan>{{"left", range}};
         }},
        {"Change the reference joint angles of “walk”",
         [](auto& d) { setJointAngles(d, "walk", "/data/walk.bvh"); },
         [](const Project& p) { return p.sequences[0].jointAngles == "/data/walk.bvh"; }},
        {"Edit the notes of “Ada”", [](auto& d) { setCharacterNotes(d, "Ada", "short"); },
         [](const Project& p) { return p.characters[0].notes == "short"; }},
        {"Change the texture of “Ada”", [](auto& d) { setCharacterTexture(d, "Ada", texture); },
         [](const Project& p) { return p.characters[0].texture == texture; }},
        {"Change the mesh of “Ada”", [](auto& d) { setCharacterMesh(d, "Ada", "/data/eva.obj"); },
         [](const Project& p) { return p.characters[0].mesh == "/data/eva.obj"; }},
        {"Change the project settings", [](auto& d) { setSettings(d, {.fps = 60}); },
         [](const Project& p) { return p.settings.fps == 60; }},
        {"Add export “cache 2”",
         [](auto& d) { addExport(d, {.name = "cache", .what = "sequences/walk", .path = "/out/w.pc2"}); },
         [](const Project& p) { return p.exports.size() == 4 && p.exports[3].name == "cache 2"; }},
        {"Change export “cache”",
         [](auto& d) {
             setExport(d, "cache", {.name = "cache", .what = "sequences/jump", .path = "/out/j.pc2"});
         },
         [](const Project& p) { return p.exports[1].what == "sequences/jump"; }},
        {"Relink media",
         [](auto& d) {
             relinkMedia(d, {{"/data/ada.obj", "/new/ada.obj"}, {"/data/walk.pc2", "/new/w.pc2"}});
         },
         [](const Project& p) {
             return p.characters[0].mesh == "/new/ada.obj" && p.sequences[0].source == "/new/w.pc2";
         }},
    };
    return all;
}

} // namespace

class TestProjectEdits : public QObject
{
    Q_OBJECT

private slots:
    void everyEditIsOneStepThatGoesBackAndForth_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < edits().size(); ++i)
            QTest::newRow(qUtf8Printable(edits()[i].text)) << static_cast<int>(i);
    }
    void everyEditIsOneStepThatGoesBackAndForth()
    {
        QFETCH(int, index);
        const Edit& edit = edits()[static_cast<std::size_t>(index)];
        ProjectDocument document;
        document.reset(exampleProject());
        const Project before = document.project();
        QSignalSpy changes(&document, &ProjectDocument::changed);

        edit.run(document);
        const Project after = document.project();
        QVERIFY(edit.expected(after));
        QVERIFY(!changes.isEmpty());
        QCOMPARE(document.undoStack()->count(), 1);
        QCOMPARE(document.undoStack()->undoText(), edit.text);
        QVERIFY(document.isModified());

        document.undo();
        QVERIFY(document.project() == before);
        QVERIFY(!document.isModified());
        document.redo();
        QVERIFY(document.project() == after);
        document.undo();
        QVERIFY(document.project() == before);
    }

    void theCacheTakesTheSizeOfTheSettings()
    {
        const auto budget = [] { return MediaCache::shared()->statistics().budget; };
        JobRunner jobs;
        ProjectDocument document;
        const SequenceMedia media(document, jobs);
        Project project;
        project.settings.cacheMegabytes = 300;
        document.reset(project);
        QCOMPARE(budget(), std::size_t{300} << 20U);
        ProjectSettings settings = project.settings;
        settings.cacheMegabytes = 40;
        setSettings(document, settings);
        QCOMPARE(budget(), std::size_t{40} << 20U);
        document.undo();
        QCOMPARE(budget(), std::size_t{300} << 20U);
        document.reset({});
        QCOMPARE(budget(), MediaCache::defaultBudget);
    }

    void anEditThatChangesNothingLeavesNoTrace()
    {
        ProjectDocument document;
        document.reset(exampleProject());
        setSequenceRange(document, "jump", FrameRange{FrameIndex(2), FrameIndex(9)});
        setCharacterNotes(document, "Ada", "tall");
        QVERIFY(renameEntry(document, {Section::Sequences, "walk"}, "walk"));
        relinkMedia(document, {{"/nowhere", "/else"}});
        QCOMPARE(document.undoStack()->count(), 0);
    }

    void aNameThatIsTakenOrEmptyIsRefused()
    {
        ProjectDocument document;
        document.reset(exampleProject());
        QVERIFY(!renameEntry(document, {Section::Sequences, "walk"}, "jump"));
        QVERIFY(!renameEntry(document, {Section::Sequences, "walk"}, "  "));
        QVERIFY(document.project() == exampleProject());
    }

    void aDragIsOneStep()
    {
        ProjectDocument document;
        document.reset(exampleProject());
        for (int last = 8; last > 4; --last)
            setSequenceRange(document, "jump", FrameRange{FrameIndex(2), FrameIndex(last)},
                             EditPhase::Dragging);
        setSequenceRange(document, "jump", FrameRange{FrameIndex(2), FrameIndex(4)}, EditPhase::Final);
        QCOMPARE(document.undoStack()->count(), 1);
        QCOMPARE(document.sequence("jump")->range->last, FrameIndex(4));
        setSequenceRange(document, "jump", FrameRange{FrameIndex(2), FrameIndex(3)}, EditPhase::Final);
        QCOMPARE(document.undoStack()->count(), 2);
        document.undo();
        document.undo();
        QVERIFY(document.project() == exampleProject());
    }

    void aDragThatComesBackDropsItself()
    {
        ProjectDocument document;
        document.reset(exampleProject());
        setSequenceRange(document, "jump", FrameRange{FrameIndex(4), FrameIndex(9)}, EditPhase::Dragging);
        setSequenceRange(document, "jump", FrameRange{FrameIndex(2), FrameIndex(9)}, EditPhase::Final);
        QCOMPARE(document.undoStack()->count(), 0);
        QVERIFY(document.project() == exampleProject());
    }

    void dragsOfTwoValuesStaySeparate()
    {
        ProjectDocument document;
        document.reset(exampleProject());
        setSequenceFps(document, "walk", 20, EditPhase::Dragging);
        setSequenceRange(document, "walk", FrameRange{FrameIndex(0), FrameIndex(1)}, EditPhase::Dragging);
        setSequenceRange(document, "jump", FrameRange{FrameIndex(0), FrameIndex(1)}, EditPhase::Dragging);
        QCOMPARE(document.undoStack()->count(), 3);
    }

    void oldEditsBeyondTheBudgetCannotBeUndone()
    {
        ProjectDocument document;
        document.reset(exampleProject());
        document.setHistoryBytes(100000);
        for (int i = 0; i < 10; ++i)
            setCharacterNotes(document, "Ada", QString(20000, QChar('a' + i)));
        int undone = 0;
        while (document.canUndo()) {
            document.undo();
            ++undone;
        }
        QVERIFY(undone >= 1);
        QVERIFY(undone < 10);
        QCOMPARE(document.character("Ada")->notes.front(), static_cast<char>('a' + 9 - undone));
        for (int i = 0; i < undone; ++i)
            document.redo();
        QCOMPARE(document.character("Ada")->notes.front(), 'j');
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST_IN(QCoreApplication, quadrille::TestProjectEdits);
#include "tst_projectedits.moc"

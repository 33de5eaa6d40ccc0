// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Random edits through the commands: whatever they try, the project can be saved and comes back equal.
#include "editor/commands/animationedits.h"
#include "editor/commands/projectedits.h"
#include "editor/commands/variationedits.h"
#include "editor/documents/editcheck.h"
#include "editor/documents/projectpaths.h"
#include "model/project/file/projectjson.h"
#include "model/project/file/usableproject.h"
#include "model/project/json/jsontext.h"
#include "tests/qt/registry.h"

#include <QTemporaryDir>
#include <QTest>
#include <limits>
#include <random>

namespace quadrille {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// Makes random edits, good and bad ones.
class Editor
{
public:
    Editor(ProjectDocument& document, unsigned seed, std::string folder)
        : m_document(document), m_random(seed), m_folder(std::move(folder))
    {
    }

    void edit()
    {
        static const std::vector<void (Editor::*)()> edits{
            &Editor::rename,   &Editor::rename,    &Editor::add,      &Editor::addWithCharacter,
            &Editor::remove,   &Editor::duplicate, &Editor::range,    &Editor::rate,
            &Editor::axes,     &Editor::character, &Editor::labels,   &Editor::contacts,
            &Editor::media,    &Editor::settings,  &Editor::exported, &Editor::animation,
            &Editor::keys,     &Editor::path,      &Editor::graph,    &Editor::variation,
            &Editor::training, &Editor::body,      &Editor::undo,     &Editor::redo};
        (this->*edits[pick(edits.size())])();
    }

private:
    std::size_t pick(std::size_t count)
    {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(m_random);
    }

    template <typename Value>
    Value any(std::initializer_list<Value> values)
    {
        return values.begin()[pick(values.size())];
    }

    QString text()
    {
        return any<QString>({"walk",
                             "run",
                             "walk 2",
                             "take 1/2",
                             "..",
                             ".",
                             "",
                             "  ",
                             " spaced ",
                             "a\\b",
                             "tab\there",
                             "line\nbreak",
                             QString(300, QChar(0xE9)),
                             QString(254, 'x'),
                             "clip:walk",
                             QString::fromUtf8("名前"),
                             QString(QChar(0xD800)),
                             "\"quoted\"",
                             "3",
                             "walk/3",
                             QString(QChar(0x7F))});
    }
    std::string bytes() { return any<std::string>({text().toStdString(), "plain", "not\xffutf8"}); }
    std::string file()
    {
        return m_folder + "/" +
               any<std::string>({"a.pc2", "clip:b.pc2", "b#.obj", "c\xfe.ply", "ä ö.npy", "back\\slash.obj"});
    }
    double number()
    {
        return any<double>(
            {0, -0.0, 1, -1, 0.5, 25, 29.97, 1e-12, 1e7, 1e300, infinite, -infinite, notANumber});
    }
    std::int64_t whole() { return any<std::int64_t>({0, 1, 5, -1, 100, 1'000'000'000'000'000, -7}); }
    FrameRange frames() { return {FrameIndex(whole()), FrameIndex(whole())}; }

    template <typename Entry>
    QString nameIn(const std::vector<Entry>& entries)
    {
        return entries.empty() ? QString() : QString::fromStdString(entries[pick(entries.size())].name);
    }
    const Project& project() const { return m_document.project(); }
    QString sequenceName() { return nameIn(project().sequences); }
    EntryRef entry()
    {
        switch (pick(5)) {
        case 0:
            return {Section::Characters, nameIn(project().characters)};
        case 1:
            return {Section::Sequences, sequenceName()};
        case 2:
            return {Section::Animations, nameIn(project().animations)};
        case 3:
            return {Section::Variations, nameIn(project().variations)};
        default:
            return {Section::Exports, nameIn(project().exports)};
        }
    }

    void rename()
    {
        const EntryRef ref = entry();
        if (!ref.name.isEmpty())
            renameEntry(m_document, ref, text());
    }
    void add()
    {
        SequenceEntry added{.name = bytes(), .character = nameIn(project().characters).toStdString()};
        added.source = pick(3) == 0 ? "clip:sequences/" + sequenceName().toStdString() : file();
        addSequences(m_document, {added}, {}, pick(4) == 0 ? std::optional(number()) : std::nullopt);
    }
    void addWithCharacter()
    {
        const std::string name = bytes();
        addSequences(m_document, {{.name = bytes(), .character = name, .source = file()}},
                     {{.name = name, .mesh = file()}});
    }
    void remove()
    {
        const EntryRef ref = entry();
        if (!ref.name.isEmpty() && pick(3) == 0)
            removeEntries(m_document, ref.section, {ref.name});
    }
    void duplicate()
    {
        const EntryRef ref = entry();
        if (ref.name.isEmpty() || project().sequences.size() > 20)
            return;
        if (ref.section == Section::Sequences)
            duplicateSequence(m_document, ref.name);
        else if (ref.section == Section::Animations)
            duplicateAnimation(m_document, ref.name);
        else if (ref.section == Section::Variations)
            duplicateVariation(m_document, ref.name);
    }
    void range()
    {
        if (const QString name = sequenceName(); !name.isEmpty())
            setSequenceRange(m_document, name, pick(3) == 0 ? std::nullopt : std::optional(frames()));
    }
    void rate()
    {
        if (const QString name = sequenceName(); !name.isEmpty())
            setSequenceFps(m_document, name, number());
    }
    void axes()
    {
        if (const QString name = sequenceName(); !name.isEmpty())
            setSequenceAxes(m_document, name, CoordinateSystem{any({UpAxis::X, UpAxis::Y}), number()});
    }
    void character()
    {
        if (const QString name = sequenceName(); !name.isEmpty())
            setSequenceCharacter(m_document, name, pick(2) == 0 ? nameIn(project().characters) : text());
    }
    void labels()
    {
        if (const QString name = sequenceName(); !name.isEmpty())
            setSequenceLabels(m_document, name, {{bytes(), frames()}, {"step", frames()}},
                              any({EditPhase::Dragging, EditPhase::Final}));
    }
    void contacts()
    {
        if (const QString name = sequenceName(); !name.isEmpty())
            setSequenceContacts(m_document, name, {{bytes(), frames()}});
    }
    void media()
    {
        const TextureReference texture{TextureReference::Kind::PerFrame, {file()}, {}};
        if (const QString name = sequenceName(); !name.isEmpty()) {
            setSequenceTexture(m_document, name, texture);
            setJointAngles(m_document, name, file());
        }
        if (const QString name = nameIn(project().characters); !name.isEmpty()) {
            setCharacterNotes(m_document, name, text());
            setCharacterMesh(m_document, name, file());
            setCharacterTexture(m_document, name, texture);
        }
        relinkMedia(m_document, {{file(), file()}});
    }
    void settings()
    {
        ProjectSettings after = project().settings;
        after.fps = number();
        after.axes.up = any({UpAxis::X, UpAxis::Y, UpAxis::Z});
        after.cacheMegabytes = whole();
        setSettings(m_document, after);
    }
    void exported()
    {
        ExportEntry added{.name = bytes(), .what = "sequences/" + sequenceName().toStdString()};
        added.path = file();
        added.range = frames();
        added.fps = number();
        addExport(m_document, added);
        if (const QString name = nameIn(project().exports); !name.isEmpty()) {
            added.name = name.toStdString();
            setExport(m_document, name, added);
        }
    }
    void animation()
    {
        AnimationEntry added;
        added.name = bytes();
        added.character = nameIn(project().characters).toStdString();
        addAnimation(m_document, added);
    }
    template <typename Edit>
    void editAnimation(const Edit& edit)
    {
        const QString name = nameIn(project().animations);
        if (name.isEmpty())
            return;
        AnimationEntry after = *m_document.animation(name);
        edit(after);
        setAnimation(m_document, name, "Edit", "edit", after, any({EditPhase::Dragging, EditPhase::Final}));
    }
    void keys()
    {
        editAnimation([this](AnimationEntry& after) {
            KeyEntry key;
            key.sequence = pick(4) == 0 ? bytes() : sequenceName().toStdString();
            key.frame = FrameIndex(whole());
            key.time = number();
            after.constraints = {key};
            after.search.beta = number();
            after.search.budget = whole();
        });
    }
    void path()
    {
        editAnimation([this](AnimationEntry& after) {
            PathEntry path;
            path.inSpace = true;
            path.points = {Vec3d(0, 0, 0), Vec3d(1, number(), 0)};
            path.points.resize(1 + pick(2), Vec3d::Zero());
            path.spans = {{.from = number(), .to = number(), .duration = number()}};
            after.constraints = {path};
            if (pick(2) == 0)
                after.audio = AudioEntry{.file = file(), .offset = number(), .gain = number()};
        });
    }
    void graph()
    {
        GraphEntry after = graphEntry(project(), nameIn(project().characters));
        after.slope = static_cast<int>(pick(7));
        after.alpha = number();
        after.durations = {number(), number()};
        if (!project().characters.empty())
            setGraph(m_document, "Edit", "edit", after);
    }
    void variation()
    {
        VariationEntry added;
        added.name = bytes();
        added.character = nameIn(project().characters).toStdString();
        addVariation(m_document, added);
    }
    void training()
    {
        const QString name = nameIn(project().variations);
        if (name.isEmpty())
            return;
        VariationEntry after = *m_document.variation(name);
        after.training = {{.sequence = sequenceName().toStdString(), .range = frames()}};
        after.learning.dimensions = static_cast<int>(whole() % 100);
        after.displacementShare = number();
        setVariation(m_document, name, "Edit", "edit", after);
    }
    void body()
    {
        if (project().characters.empty())
            return;
        BodyPartsEntry after = bodyPartsEntry(project(), nameIn(project().characters));
        PartEntry part;
        part.part.name = bytes();
        after.parts.push_back(part);
        setBodyParts(m_document, "Edit", "edit", after);
    }
    void undo() { m_document.undo(); }
    void redo() { m_document.redo(); }

    ProjectDocument& m_document;
    std::mt19937 m_random;
    std::string m_folder;
};

QByteArray firstProblem(const Project& project)
{
    const ProjectProblems problems = problemsWhenSaved(project);
    return problems.empty()
               ? QByteArray()
               : QByteArray::fromStdString(problems.front().pointer + ": " + problems.front().toString());
}

QByteArray writtenOf(const Project& project)
{
    return QByteArray::fromStdString(writeJson(projectToJson(project)));
}

/// The section in which two projects differ.
const char* differenceOf(const Project& a, const Project& b)
{
    return !(a.settings == b.settings)    ? "settings"
           : a.characters != b.characters ? "characters"
           : a.sequences != b.sequences   ? "sequences"
           : a.bodyParts != b.bodyParts   ? "body parts"
           : a.graphs != b.graphs         ? "graphs"
           : a.animations != b.animations ? "animations"
           : a.variations != b.variations ? "variations"
           : a.exports != b.exports       ? "exports"
                                          : "something else";
}

} // namespace

class EditFuzzTest : public QObject
{
    Q_OBJECT

private slots:
    void whateverIsEditedCanBeSavedAndComesBackEqual_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 40; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }

    void whateverIsEditedCanBeSavedAndComesBackEqual()
    {
        QFETCH(unsigned, seed);
        const QTemporaryDir folder;
        const auto file = toPath(folder.filePath("p.quadrille"));
        ProjectDocument document;
        int refusals = 0;
        connect(&EditRefusals::of(document), &EditRefusals::refused, this, [&] { ++refusals; });
        Editor editor(document, seed, folder.path().toStdString());
        for (int i = 1; i <= 160; ++i) {
            editor.edit();
            QCOMPARE(firstProblem(document.project()), QByteArray());
            if (i % 20 != 0)
                continue;
            document.saveAs(file);
            ProjectDocument other;
            other.load(file);
            QVERIFY(brokenEntries(other.project()).empty());
            QCOMPARE(writtenOf(other.project()), writtenOf(document.project()));
            QVERIFY2(other.project() == document.project(),
                     differenceOf(other.project(), document.project()));
        }
        QVERIFY(refusals > 0);
        QVERIFY(document.undoStack()->count() > 5);
        while (document.canUndo()) {
            document.undo();
            QCOMPARE(firstProblem(document.project()), QByteArray());
        }
    }
};

} // namespace quadrille

QUADRILLE_QT_TEST_IN(QCoreApplication, quadrille::EditFuzzTest);
#include "tst_editfuzz.moc"

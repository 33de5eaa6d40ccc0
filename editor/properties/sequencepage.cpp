// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/sequencepage.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/fields/axesfields.h"
#include "editor/fields/rangefield.h"
#include "editor/fields/texturefield.h"
#include "model/project/document/findentry.h"
#include "widgets/controls/breakable.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>

namespace quadrille {

SequencePage::SequencePage(EditorContext& context)
    : m_context(context)
    , m_nameField(new QLineEdit)
    , m_character(new QComboBox)
    , m_range(new RangeField("sequence"))
    , m_fields(*this, [this](const QString& /*text*/, const char* /*property*/,
                             const auto& change) { editSource(change); })
    , m_axes(new AxesFields)
    , m_texture(new TextureField)
    , m_jointAngles(new widgets::ElidedButton)
{
    makeFields();
    connectFields();
    retranslate();
}

void SequencePage::makeFields()
{
    m_character->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_jointAngles->setMenu(new QMenu(m_jointAngles));

    addField(
        "sequenceName", [] { return tr("Name"); }, m_nameField, [] { return tr("Unique in the project"); });
    m_source = addFact("sequenceSource", [] { return tr("Source"); });
    addField(
        "sequenceCharacter", [] { return tr("Character"); }, m_character,
        [] { return tr("Whose mesh gives faces and texture coordinates"); });
    m_length = addFact("sequenceLength", [] { return tr("Length"); });
    addField(
        "sequenceRange", [] { return tr("Frames"); }, m_range,
        [] { return tr("First and last frame of the source that are used, from 0"); });
    addSource();
    addField(
        "sequenceTexture", [] { return tr("Textures"); }, m_texture,
        [] {
            return tr("Its own textures; automatic are the character's, or those found beside the source");
        });
    addField(
        "sequenceJointAngles", [] { return tr("Joint angles"); }, m_jointAngles,
        [] { return tr("A BVH with the true joint angles, used to evaluate results"); });
    m_marks = addFact("sequenceMarks", [] { return tr("Marks"); });
    m_notes = addFact("sequenceNotes", [] { return tr("Findings"); });
}

void SequencePage::addSource()
{
    const auto hasAxes = [](const SequenceEntry& entry) { return entry.sourceAxes.has_value(); };
    m_fields.addNumber(
        {"sequenceFps", [] { return tr("Source rate"); },
         [] { return tr("Frames a second of a source that names none; automatic is the project's rate"); }},
        &SequenceEntry::sourceFps, rateLook("sequence.source_fps", [] { return tr("automatic"); }));
    m_fields.addChoice(
        {"sequenceHasAxes", [] { return tr("Source axes"); },
         [] { return tr("Whether the source has other axes or another unit than metres with y up"); }},
        Lens<SequenceEntry, bool>{hasAxes,
                                  [this](SequenceEntry& entry, bool has) {
                                      entry.sourceAxes = has ? std::optional(m_axes->axes()) : std::nullopt;
                                  }},
        {[] { return tr("metres, y up"); }, [] { return tr("others", "axes"); }});
    m_fields.addOther({"sequenceAxes", [] { return QString(); },
                       [] { return tr("Up axis and unit of the source"); }, hasAxes},
                      m_axes, [this](const SequenceEntry& entry) {
                          m_axes->setAxes(entry.sourceAxes.value_or(CoordinateSystem{}));
                      });
}

void SequencePage::connectFields()
{
    ProjectDocument& document = m_context.document;
    connect(m_nameField, &QLineEdit::editingFinished, this, [this, &document] {
        renameEntry(document, {Section::Sequences, m_name}, m_nameField->text());
    });
    connect(m_character, &QComboBox::textActivated, this,
            [this, &document](const QString& name) { setSequenceCharacter(document, m_name, name); });
    connect(m_range, &RangeField::edited, this,
            [this, &document] { setSequenceRange(document, m_name, m_range->range()); });
    connect(m_axes, &AxesFields::edited, this,
            [this] { editSource([this](SequenceEntry& entry) { entry.sourceAxes = m_axes->axes(); }); });
    connect(m_texture, &TextureField::chosen, this, [this, &document](const TextureReference& texture) {
        setSequenceTexture(document, m_name, texture);
    });
}

void SequencePage::show(const QString& name)
{
    m_name = name;
    const SequenceEntry& entry = *m_context.document.sequence(name);
    showName(*m_nameField, name);
    const QString source = QString::fromStdString(entry.source);
    const QString clip = QString::fromStdString(entry.clip);
    const QString file = QFileInfo(source).fileName();
    m_source->setText(clip.isEmpty() ? file : tr("%1, clip %2").arg(file, clip));
    m_source->setToolTip(source);
    m_character->clear();
    for (const CharacterEntry& character : m_context.document.project().characters)
        m_character->addItem(QString::fromStdString(character.name));
    if (const CharacterEntry* own = m_context.document.characterOf(entry))
        m_character->setCurrentText(QString::fromStdString(own->name));
    m_fields.show(entry);
    m_texture->setTexture(entry.texture, tr("automatic"));
    m_jointAngles->setText(entry.jointAngles.empty()
                               ? tr("none")
                               : QFileInfo(QString::fromStdString(entry.jointAngles)).fileName());
    m_marks->setText(tr("%1 · %2").arg(tr("%n labels", nullptr, static_cast<int>(entry.labels.size())),
                                       tr("%n contacts", nullptr, static_cast<int>(entry.contacts.size()))));
    showResultState(entry);
}

void SequencePage::showResultState(const SequenceEntry& entry)
{
    const SequenceMedia::State* resultState = m_context.media.resultState(m_name);
    const bool isOpen = resultState != nullptr && resultState->whole.has_value();
    m_range->setRange(entry.range, isOpen ? resultState->whole->frameCount() : 0);
    m_notes->clear();
    if (!isOpen) {
        const bool hasFailed = resultState != nullptr && resultState->error;
        m_length->setText(hasFailed ? widgets::breakable(describe(*resultState->error).oneLine())
                                    : tr("opening…"));
        return;
    }
    const MeshSequence& shown = resultState->sequence ? *resultState->sequence : *resultState->whole;
    m_length->setText(
        tr("%n frames, %1 s", nullptr, static_cast<int>(shown.frameCount()))
            .arg(QLocale().toString(static_cast<double>(shown.frameCount()) / shown.fps, 'f', 2)));
    QStringList notes;
    for (const Issue& issue : resultState->issues)
        notes += describe(issue).oneLine();
    m_notes->setText(notes.isEmpty() ? tr("none", "findings")
                                     : widgets::breakable(notes.join(QLatin1Char('\n'))));
}

void SequencePage::editSource(const std::function<void(SequenceEntry&)>& change)
{
    const SequenceEntry& before = *m_context.document.sequence(m_name);
    SequenceEntry after = before;
    change(after);
    if (after.sourceFps != before.sourceFps)
        setSequenceFps(m_context.document, m_name, after.sourceFps);
    else
        setSequenceAxes(m_context.document, m_name, after.sourceAxes);
}

void SequencePage::chooseJointAngles()
{
    const QString file = QFileDialog::getOpenFileName(this, tr("Reference joint angles"), m_source->toolTip(),
                                                      tr("BVH (*.bvh)"));
    if (!file.isEmpty())
        setJointAngles(m_context.document, m_name, file.toStdString());
}

void SequencePage::retranslate()
{
    m_fields.retranslate();
    m_jointAngles->menu()->clear();
    m_jointAngles->menu()->addAction(tr("Choose…"), this, &SequencePage::chooseJointAngles);
    m_jointAngles->menu()->addAction(tr("None"), this,
                                     [this] { setJointAngles(m_context.document, m_name, {}); });
}

} // namespace quadrille

#include "moc_sequencepage.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/sequencepage.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/fields/axesfields.h"
#include "editor/fields/numberfield.h"
#include "editor/fields/texturefield.h"
#include "model/project/document/findentry.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QRegularExpression>

namespace quadrille {

namespace {

/// Lets lines end within long paths and names, or they would widen the dock.
QString breakable(QString text)
{
    static const QRegularExpression joint(QStringLiteral("([/_.])"));
    return text.replace(joint, QStringLiteral("\\1\u200B"));
}

} // namespace

SequencePage::SequencePage(EditorContext& context)
    : m_context(context)
    , m_nameField(new QLineEdit)
    , m_character(new QComboBox)
    , m_range(new QWidget)
    , m_first(new QSpinBox)
    , m_last(new QSpinBox)
    , m_fps(makeRateField(true))
    , m_hasAxes(new QComboBox)
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
    m_first->setObjectName(QStringLiteral("sequenceFirst"));
    m_last->setObjectName(QStringLiteral("sequenceLast"));
    auto* range = new QHBoxLayout(m_range);
    range->setContentsMargins(0, 0, 0, 0);
    range->setSpacing(4);
    for (QSpinBox* field : {m_first, m_last}) {
        field->setKeyboardTracking(false);
        range->addWidget(field, 1);
    }
    m_range->setFocusProxy(m_first);
    for (QComboBox* field : {m_character, m_hasAxes})
        field->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_hasAxes->addItems({QString(), QString()});
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
    addField(
        "sequenceFps", [] { return tr("Source rate"); }, m_fps,
        [] { return tr("Frames a second of a source that names none; automatic is the project's rate"); });
    addField(
        "sequenceHasAxes", [] { return tr("Source axes"); }, m_hasAxes,
        [] { return tr("Whether the source has other axes or another unit than metres with y up"); });
    addField(
        "sequenceAxes", [] { return QString(); }, m_axes,
        [] { return tr("Up axis and unit of the source"); });
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

void SequencePage::connectFields()
{
    ProjectDocument& document = m_context.document;
    connect(m_nameField, &QLineEdit::editingFinished, this, [this, &document] {
        renameEntry(document, {Section::Sequences, m_name}, m_nameField->text());
    });
    connect(m_character, &QComboBox::textActivated, this,
            [this, &document](const QString& name) { setSequenceCharacter(document, m_name, name); });
    connect(m_first, &QSpinBox::valueChanged, this, &SequencePage::editRange);
    connect(m_last, &QSpinBox::valueChanged, this, &SequencePage::editRange);
    connect(m_fps, &QDoubleSpinBox::valueChanged, this, [this, &document](double fps) {
        setSequenceFps(document, m_name, fps > 0 ? std::optional(fps) : std::nullopt);
    });
    connect(m_hasAxes, &QComboBox::currentIndexChanged, this, &SequencePage::editAxes);
    connect(m_axes, &AxesFields::edited, this, &SequencePage::editAxes);
    connect(m_texture, &TextureField::chosen, this, [this, &document](const TextureReference& texture) {
        setSequenceTexture(document, m_name, texture);
    });
}

void SequencePage::show(const QString& name)
{
    m_name = name;
    const SequenceEntry& entry = *m_context.document.sequence(name);
    const QSignalBlocker blocks[] = {QSignalBlocker(m_first), QSignalBlocker(m_last), QSignalBlocker(m_fps),
                                     QSignalBlocker(m_hasAxes)};
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
    m_fps->setValue(entry.sourceFps.value_or(0));
    m_hasAxes->setCurrentIndex(entry.sourceAxes.has_value() ? 1 : 0);
    setFieldVisible(m_axes, entry.sourceAxes.has_value());
    m_axes->setAxes(entry.sourceAxes.value_or(CoordinateSystem{}));
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
    m_first->setEnabled(isOpen);
    m_last->setEnabled(isOpen);
    m_notes->clear();
    if (!isOpen) {
        const bool hasFailed = resultState != nullptr && resultState->error;
        m_length->setText(hasFailed ? breakable(describe(*resultState->error).oneLine()) : tr("opening…"));
        return;
    }
    const auto last = static_cast<int>(resultState->whole->frameCount() - 1);
    const FrameRange range = entry.range.value_or(FrameRange::all(last + 1));
    m_first->setRange(0, static_cast<int>(range.last.value));
    m_last->setRange(static_cast<int>(range.first.value), last);
    m_first->setValue(static_cast<int>(range.first.value));
    m_last->setValue(static_cast<int>(range.last.value));
    const MeshSequence& shown = resultState->sequence ? *resultState->sequence : *resultState->whole;
    m_length->setText(
        tr("%n frames, %1 s", nullptr, static_cast<int>(shown.frameCount()))
            .arg(QLocale().toString(static_cast<double>(shown.frameCount()) / shown.fps, 'f', 2)));
    QStringList notes;
    for (const Issue& issue : resultState->issues)
        notes += describe(issue).oneLine();
    m_notes->setText(notes.isEmpty() ? tr("none", "findings") : breakable(notes.join(QLatin1Char('\n'))));
}

void SequencePage::editRange()
{
    const SequenceMedia::State* resultState = m_context.media.resultState(m_name);
    if (resultState == nullptr || !resultState->whole)
        return;
    const FrameRange range{FrameIndex(m_first->value()), FrameIndex(m_last->value())};
    const bool isAll = range == FrameRange::all(resultState->whole->frameCount());
    setSequenceRange(m_context.document, m_name, isAll ? std::nullopt : std::optional(range));
}

void SequencePage::editAxes()
{
    setSequenceAxes(m_context.document, m_name,
                    m_hasAxes->currentIndex() == 1 ? std::optional(m_axes->axes()) : std::nullopt);
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
    m_fps->setSuffix(tr(" fps"));
    m_fps->setSpecialValueText(tr("automatic"));
    m_hasAxes->setItemText(0, tr("metres, y up"));
    m_hasAxes->setItemText(1, tr("others", "axes"));
    m_last->setAccessibleName(tr("Last frame"));
    m_first->setAccessibleName(tr("First frame"));
    m_jointAngles->menu()->clear();
    m_jointAngles->menu()->addAction(tr("Choose…"), this, &SequencePage::chooseJointAngles);
    m_jointAngles->menu()->addAction(tr("None"), this,
                                     [this] { setJointAngles(m_context.document, m_name, {}); });
}

} // namespace quadrille

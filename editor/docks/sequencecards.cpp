// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/sequencecards.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/docks/cardpictures.h"
#include "editor/documents/labelcolors.h"
#include "editor/errors/errortext.h"
#include "model/project/document/findentry.h"
#include "widgets/theme/theme.h"
#include "widgets/timeline/draggedframes.h"

#include <QLocale>
#include <QMimeData>

namespace quadrille {

namespace {

/// The labels of a sequence, each once, in the order of time.
QStringList labelNames(const SequenceEntry& entry)
{
    std::vector<LabelSpan> spans = entry.labels;
    std::ranges::stable_sort(spans, {}, [](const LabelSpan& span) { return span.frames.first; });
    QStringList names;
    for (const LabelSpan& span : spans)
        names += QString::fromStdString(span.label);
    names.removeDuplicates();
    return names;
}

} // namespace

SequenceCards::SequenceCards(EditorContext& context, QObject* parent)
    : QAbstractListModel(parent), m_context(context), m_pictures(new CardPictures(context, this))
{
    connect(&context.document, &ProjectDocument::changed, this, &SequenceCards::follow);
    connect(&context.media, &SequenceMedia::changed, this, &SequenceCards::changed);
    connect(m_pictures, &CardPictures::drawn, this, [this](const QString& name) {
        const QModelIndex index = indexOf(name);
        if (index.isValid())
            emit dataChanged(index, index, {PicturesRole});
    });
}

const std::vector<SequenceEntry>& SequenceCards::entries() const
{
    return m_context.document.project().sequences;
}

QString SequenceCards::name(const QModelIndex& index) const
{
    const auto row = static_cast<std::size_t>(index.row());
    return index.isValid() && row < entries().size() ? QString::fromStdString(entries()[row].name)
                                                     : QString();
}

QModelIndex SequenceCards::indexOf(const QString& name) const
{
    const auto found = std::ranges::find(entries(), name.toStdString(), &SequenceEntry::name);
    return found == entries().end() ? QModelIndex() : index(static_cast<int>(found - entries().begin()));
}

int SequenceCards::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(entries().size());
}

Qt::ItemFlags SequenceCards::flags(const QModelIndex& index) const
{
    return QAbstractListModel::flags(index) | Qt::ItemIsEditable | Qt::ItemIsDragEnabled;
}

void SequenceCards::setMoving(const QModelIndex& index, int phase)
{
    m_moving = name(index);
    m_phase = phase;
}

int SequenceCards::shownPicture(const QModelIndex& index) const
{
    const auto count = static_cast<int>(m_pictures->countOf(name(index)));
    const int phase = name(index) == m_moving ? m_phase : 0;
    return count == 0 ? 0 : (count / 3 + phase) % count;
}

FrameIndex SequenceCards::shownFrame(const QModelIndex& index) const
{
    const MeshSequence* sequence = m_context.media.sequence(name(index));
    if (sequence == nullptr)
        return FrameIndex(0);
    const std::int64_t frames = sequence->frameCount();
    const std::int64_t count = m_pictures->countOf(name(index));
    return FrameIndex(count == 0 ? frames / 3 : shownPicture(index) * frames / count);
}

QStringList SequenceCards::mimeTypes() const
{
    return {widgets::draggedFramesType()};
}

QMimeData* SequenceCards::mimeData(const QModelIndexList& indexes) const
{
    std::vector<widgets::DraggedFrames> frames;
    for (const QModelIndex& index : indexes)
        frames.push_back({.sequence = name(index), .frame = static_cast<int>(shownFrame(index).value)});
    return widgets::toMimeData(frames).release();
}

QVariant SequenceCards::data(const QModelIndex& index, int role) const
{
    const QString shown = name(index);
    const auto* resultState = m_context.media.resultState(shown);
    if (shown.isEmpty())
        return {};
    const SequenceEntry& entry = entries()[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return shown;
    case Qt::ToolTipRole:
        return tip(shown, entry);
    case Qt::AccessibleDescriptionRole:
    case LengthRole:
        return length(shown);
    case PicturesRole:
        return QVariant::fromValue(m_pictures->pictures(shown));
    case ColorRole:
        return colorOf(entry);
    case SecondsRole: {
        const MeshSequence* sequence = m_context.media.sequence(shown);
        return sequence == nullptr ? 0.0 : sequence->duration().value;
    }
    case LabelNamesRole:
        return labelNames(entry);
    case LabelsRole:
        return QVariant::fromValue(labels(entry));
    case StateRole:
        return static_cast<int>(resultState == nullptr ? ResultPhase::Computing : resultState->phase);
    case SearchRole:
        return shown + QLatin1Char('\n') + labelNames(entry).join(QLatin1Char('\n'));
    default:
        return {};
    }
}

bool SequenceCards::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const QString after = value.toString().trimmed();
    if (role != Qt::EditRole || name(index).isEmpty() || after == name(index))
        return false;
    return renameEntry(m_context.document, {Section::Sequences, name(index)}, after);
}

QString SequenceCards::length(const QString& name) const
{
    const auto* resultState = m_context.media.resultState(name);
    if (resultState != nullptr && resultState->phase == ResultPhase::Failed)
        return tr("Cannot be opened");
    const MeshSequence* sequence = m_context.media.sequence(name);
    if (sequence == nullptr)
        return tr("Opening…");
    const QLocale locale;
    return tr("%1 s · %2 fps\n%n frames", nullptr, static_cast<int>(sequence->frameCount()))
        .arg(locale.toString(sequence->duration().value, 'f', 2), locale.toString(sequence->fps));
}

/// What is wrong with it, or what there is no room for on the card.
QString SequenceCards::tip(const QString& name, const SequenceEntry& entry) const
{
    const auto* resultState = m_context.media.resultState(name);
    if (resultState != nullptr && resultState->error)
        return describe(*resultState->error).oneLine();
    const QStringList labels = labelNames(entry);
    return labels.isEmpty() ? name : name + QLatin1Char('\n') + labels.join(QStringLiteral(" · "));
}

QColor SequenceCards::colorOf(const SequenceEntry& entry) const
{
    int place = 0;
    for (const SequenceEntry& each : entries()) {
        if (&each == &entry)
            break;
        if (m_context.document.characterOf(each) == m_context.document.characterOf(entry))
            ++place;
    }
    return widgets::Theme::categorical(place);
}

QList<CardLabel> SequenceCards::labels(const SequenceEntry& entry) const
{
    const MeshSequence* sequence = m_context.media.sequence(QString::fromStdString(entry.name));
    QList<CardLabel> result;
    if (sequence == nullptr)
        return result;
    const auto frames = static_cast<double>(sequence->frameCount());
    for (const LabelSpan& span : entry.labels) {
        result.push_back({static_cast<double>(span.frames.first.value) / frames,
                          static_cast<double>(span.frames.last.value + 1) / frames,
                          QString::fromStdString(span.label),
                          LabelColors::of(m_context.document).color(span.label)});
    }
    return result;
}

void SequenceCards::follow(const ChangeEvent& event)
{
    if (!event.touches(Section::Sequences))
        return;
    if (event.kind == ChangeEvent::Kind::Renamed || event.kind == ChangeEvent::Kind::Entry) {
        changed(event.entry.name);
        return;
    }
    beginResetModel();
    endResetModel();
}

void SequenceCards::changed(const QString& name)
{
    const QModelIndex index = indexOf(name);
    if (index.isValid())
        emit dataChanged(index, index);
}

} // namespace quadrille

#include "moc_sequencecards.cpp"

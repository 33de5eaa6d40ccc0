// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/sequencecards.h"

#include "editor/application/editorcontext.h"
#include "editor/commands/projectedits.h"
#include "editor/errors/errortext.h"
#include "editor/pictures/pictures.h"
#include "model/render/thumbnail.h"
#include "widgets/theme/theme.h"
#include "widgets/timeline/draggedframes.h"

#include <QLocale>
#include <QMimeData>
#include <set>

namespace quadrille {

namespace {

constexpr int picturesPerCard = 12;
constexpr int settleMilliseconds = 300;

} // namespace

SequenceCards::SequenceCards(EditorContext& context, QObject* parent)
    : QAbstractListModel(parent), m_context(context)
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(settleMilliseconds);
    connect(&m_soon, &QTimer::timeout, this, &SequenceCards::drawNext);
    connect(&context.document, &ProjectDocument::changed, this, &SequenceCards::follow);
    connect(&context.media, &SequenceMedia::changed, this, &SequenceCards::changed);
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

void SequenceCards::setActive(bool active, double devicePixelRatio)
{
    m_isActive = active;
    m_pixels = qRound(pictureSize * devicePixelRatio);
    if (active)
        m_soon.start();
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
    const auto found = m_pictures.find(name(index));
    const int count = found == m_pictures.end() ? 0 : static_cast<int>(found->second.images.size());
    const int phase = name(index) == m_moving ? m_phase : 0;
    return count == 0 ? 0 : (count / 3 + phase) % count;
}

FrameIndex SequenceCards::shownFrame(const QModelIndex& index) const
{
    const MeshSequence* sequence = m_context.media.sequence(name(index));
    const auto found = m_pictures.find(name(index));
    if (sequence == nullptr)
        return FrameIndex(0);
    const std::int64_t frames = sequence->frameCount();
    const std::int64_t count =
        found == m_pictures.end() ? 0 : static_cast<std::int64_t>(found->second.images.size());
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
    const auto* medium = m_context.media.medium(shown);
    if (shown.isEmpty())
        return {};
    const SequenceEntry& entry = entries()[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return shown;
    case Qt::ToolTipRole:
        return medium != nullptr && medium->error ? describe(*medium->error).oneLine() : QVariant();
    case Qt::AccessibleDescriptionRole:
    case LengthRole:
        return length(shown);
    case PicturesRole: {
        const auto found = m_pictures.find(shown);
        return QVariant::fromValue(found == m_pictures.end() ? QList<QImage>() : found->second.images);
    }
    case LabelsRole:
        return QVariant::fromValue(labels(entry));
    case StateRole:
        return static_cast<int>(medium == nullptr ? SequenceMedia::State::Loading : medium->state);
    case SearchRole: {
        QString text = shown;
        for (const LabelSpan& label : entry.labels)
            text += QLatin1Char('\n') + QString::fromStdString(label.label);
        return text;
    }
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
    const auto* medium = m_context.media.medium(name);
    if (medium != nullptr && medium->state == SequenceMedia::State::Failed)
        return tr("Cannot be opened");
    const MeshSequence* sequence = m_context.media.sequence(name);
    if (sequence == nullptr)
        return tr("Opening…");
    const QLocale locale;
    return tr("%1 s · %2 fps\n%n frames", nullptr, static_cast<int>(sequence->frameCount()))
        .arg(locale.toString(sequence->duration().value, 'f', 2), locale.toString(sequence->fps));
}

QList<CardLabel> SequenceCards::labels(const SequenceEntry& entry) const
{
    std::set<std::string> all;
    for (const SequenceEntry& each : entries())
        for (const LabelSpan& span : each.labels)
            all.insert(span.label);
    const MeshSequence* sequence = m_context.media.sequence(QString::fromStdString(entry.name));
    QList<CardLabel> result;
    if (sequence == nullptr)
        return result;
    const auto frames = static_cast<double>(sequence->frameCount());
    for (const LabelSpan& span : entry.labels) {
        const auto order = std::distance(all.begin(), all.find(span.label));
        result.push_back({static_cast<double>(span.frames.first.value) / frames,
                          static_cast<double>(span.frames.last.value + 1) / frames,
                          widgets::Theme::categorical(static_cast<int>(order))});
    }
    return result;
}

void SequenceCards::follow(const ChangeEvent& event)
{
    if (!event.touches(Section::Sequences))
        return;
    if (event.kind == ChangeEvent::Kind::Renamed) {
        auto node = m_pictures.extract(event.before);
        if (!node.empty()) {
            node.key() = event.entry.name;
            m_pictures.insert(std::move(node));
        }
        changed(event.entry.name);
    } else if (event.kind == ChangeEvent::Kind::Entry) {
        changed(event.entry.name);
    } else {
        beginResetModel();
        std::erase_if(m_pictures, [this](const auto& each) {
            return m_context.document.sequence(each.first) == nullptr;
        });
        endResetModel();
        m_soon.start();
    }
}

void SequenceCards::changed(const QString& name)
{
    const QModelIndex index = indexOf(name);
    if (index.isValid())
        emit dataChanged(index, index);
    m_soon.start();
}

void SequenceCards::drawNext()
{
    if (!m_isActive || m_job)
        return;
    for (const SequenceEntry& entry : entries()) {
        const QString name = QString::fromStdString(entry.name);
        const MeshSequence* sequence = m_context.media.sequence(name);
        if (sequence == nullptr)
            continue;
        const Pictures& drawn = m_pictures[name];
        if (drawn.source != sequence->source || drawn.range != sequence->range) {
            draw(name, *sequence);
            return;
        }
    }
}

void SequenceCards::draw(const QString& name, const MeshSequence& sequence)
{
    Pictures& pictures = m_pictures[name];
    pictures.source = sequence.source;
    pictures.range = sequence.range;
    const RenderOptions look = thumbnailLook(m_pixels, m_pixels, RenderOptions::Background::Transparent,
                                             m_context.document.project().settings.axes);
    const auto goOn = [this] {
        m_job = nullptr;
        drawNext();
    };
    m_job = m_context.jobs.start(
        {.name = tr("Pictures of “%1”").arg(name),
         .receiver = this,
         .failed =
             [goOn](const Error&) {
                 goOn(); /* told where the sequence is shown */
             },
         .background = true},
        [sequence, look](const Progress& progress) {
            return thumbnailStrip(sequence, picturesPerCard, look, progress);
        },
        [this, name, source = sequence.source, goOn](std::vector<Image> strip) {
            const auto found = m_pictures.find(name);
            if (found != m_pictures.end() && found->second.source == source) {
                found->second.images.clear();
                for (Image& image : strip)
                    found->second.images.push_back(toQImage(std::move(image)));
                const QModelIndex index = indexOf(name);
                emit dataChanged(index, index, {PicturesRole});
            }
            goOn();
        });
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/cardpictures.h"

#include "editor/context/editorcontext.h"
#include "editor/pictures/pictures.h"
#include "model/render/thumbnail.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr int settleMilliseconds = 300;

std::size_t bytesOf(const QList<QImage>& images)
{
    std::size_t bytes = 0;
    for (const QImage& image : images)
        bytes += static_cast<std::size_t>(image.sizeInBytes());
    return bytes;
}

} // namespace

CardPictures::CardPictures(EditorContext& context, QObject* parent) : QObject(parent), m_context(context)
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(settleMilliseconds);
    connect(&m_soon, &QTimer::timeout, this, &CardPictures::drawNext);
    connect(&context.document, &ProjectDocument::changed, this, &CardPictures::follow);
    connect(&context.media, &SequenceMedia::changed, &m_soon, qOverload<>(&QTimer::start));
}

QList<QImage> CardPictures::pictures(const QString& sequence)
{
    const MeshSequence* opened = m_context.media.sequence(sequence);
    Item& item = m_items[sequence];
    if (opened != nullptr && (item.isDue || item.source != opened->source || item.range != opened->range)) {
        item.isDue = true;
        if (!m_soon.isActive()) {
            ++m_asked;
            m_soon.start();
        }
    }
    item.asked = m_asked;
    return item.images;
}

qsizetype CardPictures::countOf(const QString& sequence) const
{
    const auto found = m_items.find(sequence);
    return found == m_items.end() ? 0 : found->second.images.size();
}

void CardPictures::setActive(bool active, double devicePixelRatio)
{
    m_isActive = active;
    m_pixels = qRound(side * devicePixelRatio);
    if (active)
        m_soon.start();
}

std::size_t CardPictures::bytes() const
{
    std::size_t bytes = 0;
    for (const auto& [name, item] : m_items)
        bytes += bytesOf(item.images);
    return bytes;
}

void CardPictures::follow(const ChangeEvent& event)
{
    if (!event.touches(Section::Sequences))
        return;
    if (event.kind == ChangeEvent::Kind::Reset) {
        m_items.clear();
    } else if (event.kind == ChangeEvent::Kind::Renamed) {
        auto node = m_items.extract(event.before);
        if (!node.empty()) {
            node.key() = event.entry.name;
            m_items.insert(std::move(node));
        }
    } else if (event.kind != ChangeEvent::Kind::Entry) {
        std::erase_if(
            m_items, [this](const auto& each) { return m_context.document.sequence(each.first) == nullptr; });
    }
}

/// What was asked for last is looked at now; what was asked for together is drawn in the order of the
/// project.
void CardPictures::drawNext()
{
    if (!m_isActive || m_job)
        return;
    auto next = m_items.end();
    for (const SequenceEntry& entry : m_context.document.project().sequences) {
        const auto found = m_items.find(QString::fromStdString(entry.name));
        if (found != m_items.end() && found->second.isDue &&
            m_context.media.sequence(found->first) != nullptr &&
            (next == m_items.end() || found->second.asked > next->second.asked))
            next = found;
    }
    if (next != m_items.end())
        draw(next->first, *m_context.media.sequence(next->first));
}

void CardPictures::draw(const QString& name, const MeshSequence& sequence)
{
    Item& item = m_items[name];
    item.source = sequence.source;
    item.range = sequence.range;
    item.isDue = false;
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
            return thumbnailStrip(sequence, count, look, progress);
        },
        [this, source = sequence.source, range = sequence.range, goOn](std::vector<Image> strip) {
            // Not by its name: it may have another one by now.
            const auto found = std::ranges::find_if(m_items, [&](const auto& each) {
                return each.second.source == source && each.second.range == range;
            });
            if (found != m_items.end()) {
                found->second.images.clear();
                for (Image& image : strip)
                    found->second.images.push_back(toQImage(std::move(image)));
                const QString drawnFor = found->first;
                forgetOldest();
                emit drawn(drawnFor);
            }
            goOn();
        });
}

void CardPictures::forgetOldest()
{
    for (std::size_t all = bytes(); all > m_mostBytes;) {
        auto oldest = m_items.end();
        for (auto it = m_items.begin(); it != m_items.end(); ++it) {
            if (!it->second.images.isEmpty() && it->second.asked != m_asked &&
                (oldest == m_items.end() || it->second.asked < oldest->second.asked))
                oldest = it;
        }
        if (oldest == m_items.end())
            return;
        all -= bytesOf(oldest->second.images);
        m_items.erase(oldest);
    }
}

} // namespace quadrille

#include "moc_cardpictures.cpp"

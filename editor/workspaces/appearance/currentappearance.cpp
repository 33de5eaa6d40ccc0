// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/currentappearance.h"

#include "editor/commands/appearanceedits.h"
#include "editor/context/editorcontext.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/project/document/findentry.h"
#include "model/project/steps/appearancetraining.h"

#include <algorithm>
#include <utility>

namespace quadrille {

CurrentAppearance::CurrentAppearance(EditorContext& context, SceneView& view, QObject* parent)
    : QObject(parent), m_context(context), m_view(view)
{
    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.touches(Section::Appearances) || event.touches(Section::Sequences) ||
            event.touches(Section::Characters))
            emit changed();
    });
    connect(&context.selection, &Selection::changed, this, [this] {
        emit changed();
        emit resultChanged();
        emit frameChanged();
    });
    connect(&context.appearances, &AppearanceResults::changed, this, [this](const QString& name) {
        if (name == this->name())
            emit resultChanged();
    });
    connect(&context.media, &SequenceMedia::changed, this, [this](const QString& name) {
        emit changed();
        if (name == m_context.selection.shownSequence())
            emit frameChanged();
    });
    connect(&view.player(), &Player::frameChanged, this, &CurrentAppearance::frameChanged);
    connect(&view, &SceneView::sceneChanged, this, [this] {
        if (m_pending && QString::fromStdString(m_pending->sequence) == m_context.selection.shownSequence() &&
            m_view.scene().frameCount() > m_pending->frame.value)
            m_view.player().goTo(std::exchange(m_pending, std::nullopt)->frame.value);
    });
}

const QString& CurrentAppearance::name() const
{
    return m_context.selection.shownAppearance();
}

const AppearanceEntry* CurrentAppearance::entry() const
{
    return findAppearance(m_context.document.project(), name().toStdString());
}

AppearanceEntry CurrentAppearance::wantedEntry() const
{
    if (const AppearanceEntry* own = entry())
        return *own;
    AppearanceEntry wanted;
    const SequenceEntry* sequence = m_context.document.sequence(m_context.selection.shownSequence());
    if (const CharacterEntry* shown =
            sequence == nullptr ? nullptr : m_context.document.characterOf(*sequence))
        wanted.character = shown->name;
    return wanted;
}

QString CurrentAppearance::character() const
{
    return QString::fromStdString(characterNameOf(m_context.document.project(), wantedEntry()));
}

const AppearanceResults::State* CurrentAppearance::resultState() const
{
    return m_context.appearances.resultState(name());
}

OpenedAppearancePointer CurrentAppearance::opened() const
{
    const AppearanceResults::State* state = resultState();
    return state != nullptr && state->hasModel() ? state->opened : nullptr;
}

QStringList CurrentAppearance::sequences() const
{
    QStringList names;
    for (const std::string& sequence : trainingSequences(m_context.document.project(), wantedEntry()))
        names += QString::fromStdString(sequence);
    return names;
}

std::optional<bool> CurrentAppearance::hasTextures() const
{
    bool isKnown = true;
    for (const QString& name : sequences()) {
        const MeshSequence* sequence = m_context.media.sequence(name);
        if (sequence != nullptr && sequence->textures.kind() == TextureSet::Kind::PerFrame)
            return true;
        const SequenceMedia::State* state = m_context.media.resultState(name);
        isKnown = isKnown && state != nullptr && state->phase != ResultPhase::Computing;
    }
    return isKnown ? std::optional(false) : std::nullopt;
}

std::optional<NamedFrame> CurrentAppearance::frame() const
{
    const QString& name = m_context.selection.shownSequence();
    const MeshSequence* sequence = m_context.media.sequence(name);
    if (sequence == nullptr || sequence->frameCount() == 0)
        return std::nullopt;
    const std::int64_t frame =
        std::clamp<std::int64_t>(m_view.player().frame().value, 0, sequence->frameCount() - 1);
    return NamedFrame{name.toStdString(), FrameIndex(frame)};
}

Texture CurrentAppearance::textureOf(const NamedFrame& frame) const
{
    const MeshSequence* sequence = sequenceOf(frame);
    if (sequence == nullptr)
        return {};
    const int index = sequence->textures.indexFor(sequence->sourceFrame(frame.frame));
    return index < 0 ? Texture() : sequence->textures.textures()[static_cast<std::size_t>(index)];
}

const MeshSequence* CurrentAppearance::sequenceOf(const NamedFrame& frame) const
{
    const MeshSequence* sequence = m_context.media.sequence(QString::fromStdString(frame.sequence));
    return sequence != nullptr && frame.frame.value < sequence->frameCount() ? sequence : nullptr;
}

void CurrentAppearance::goTo(const NamedFrame& frame)
{
    const QString sequence = QString::fromStdString(frame.sequence);
    m_view.player().pause();
    if (m_view.scene().shown() == QStringList{sequence} && frame.frame.value < m_view.scene().frameCount()) {
        m_view.player().goTo(frame.frame.value);
        return;
    }
    m_pending = frame;
    m_context.selection.selectSequences({sequence});
}

void CurrentAppearance::edit(const QString& text, const QString& property, const Edit& edit, EditPhase phase)
{
    if (entry() == nullptr)
        return;
    AppearanceEntry after = *entry();
    edit(after);
    setAppearance(m_context.document, name(), text, property, std::move(after), phase);
}

QString CurrentAppearance::add()
{
    AppearanceEntry appearance;
    appearance.name = tr("textures").toStdString();
    if (m_context.document.project().characters.size() > 1)
        appearance.character = character().toStdString();
    QString added = addAppearance(m_context.document, std::move(appearance));
    m_context.selection.select({Section::Appearances, added});
    return added;
}

QString frameText(const NamedFrame& frame)
{
    return QStringLiteral("%1 %2").arg(QString::fromStdString(frame.sequence)).arg(frame.frame.value);
}

} // namespace quadrille

#include "moc_currentappearance.cpp"

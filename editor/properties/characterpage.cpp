// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/characterpage.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/fields/texturefield.h"
#include "model/project/document/findentry.h"

#include <QFileInfo>
#include <QLineEdit>
#include <QPlainTextEdit>

namespace quadrille {

namespace {

/// Tells when the keyboard leaves a text, so that typing is one edit.
class NotesEdit : public QPlainTextEdit
{
public:
    std::function<void()> left;

protected:
    void focusOutEvent(QFocusEvent* event) override
    {
        QPlainTextEdit::focusOutEvent(event);
        left();
    }
};

} // namespace

CharacterPage::CharacterPage(EditorContext& context)
    : m_context(context), m_nameField(new QLineEdit), m_texture(new TextureField)
{
    auto* notes = new NotesEdit;
    m_notes = notes;
    m_notes->setTabChangesFocus(true);
    m_notes->setMaximumHeight(96);
    addField(
        "characterName", [] { return tr("Name"); }, m_nameField, [] { return tr("Unique in the project"); });
    m_mesh = addFact("characterMesh", [] { return tr("Mesh"); });
    addField(
        "characterTexture", [] { return tr("Textures"); }, m_texture,
        [] { return tr("What its sequences wear, unless they have their own"); });
    m_surface = addFact("characterSurface", [] { return tr("Surface"); });
    m_sequences = addFact("characterSequences", [] { return tr("Used by"); });
    addField(
        "characterNotes", [] { return tr("Notes"); }, m_notes,
        [] { return tr("Whatever is worth remembering about the capture"); });
    connect(m_nameField, &QLineEdit::editingFinished, this, [this] {
        renameEntry(m_context.document, {Section::Characters, m_name}, m_nameField->text());
    });
    connect(m_texture, &TextureField::chosen, this, [this](const TextureReference& texture) {
        setCharacterTexture(m_context.document, m_name, texture);
    });
    notes->left = [this] {
        if (m_context.document.character(m_name) != nullptr)
            setCharacterNotes(m_context.document, m_name, m_notes->toPlainText());
    };
}

void CharacterPage::show(const QString& name)
{
    m_name = name;
    const CharacterEntry& character = *m_context.document.character(name);
    showName(*m_nameField, name);
    const QString mesh = QString::fromStdString(character.mesh);
    m_mesh->setText(mesh.isEmpty() ? tr("that of its first sequence") : QFileInfo(mesh).fileName());
    m_mesh->setToolTip(mesh);
    m_texture->setTexture(character.texture, tr("as found"));
    const QString notes = QString::fromStdString(character.notes);
    if (m_notes->toPlainText() != notes)
        m_notes->setPlainText(notes);
    showSurface();
}

void CharacterPage::showSurface()
{
    int count = 0;
    const MeshSequence* opened = nullptr;
    for (const SequenceEntry& entry : m_context.document.project().sequences) {
        const CharacterEntry* character = m_context.document.characterOf(entry);
        if (character == nullptr || QString::fromStdString(character->name) != m_name)
            continue;
        ++count;
        if (opened == nullptr)
            opened = m_context.media.untrimmed(QString::fromStdString(entry.name));
    }
    m_sequences->setText(tr("%n sequences", nullptr, count));
    if (opened == nullptr) {
        m_surface->setText(tr("not opened"));
        return;
    }
    const Topology& topology = *opened->topology;
    const TopologyStatistics& statistics = topology.statistics();
    QStringList parts{tr("%n vertices", nullptr, static_cast<int>(topology.vertexCount())),
                      tr("%n triangles", nullptr, static_cast<int>(topology.triangles().size())),
                      tr("%n components", nullptr, static_cast<int>(statistics.components)),
                      topology.isClosed()
                          ? tr("closed")
                          : tr("%n boundary loops", nullptr, static_cast<int>(statistics.boundaryLoops)),
                      topology.hasUvs() ? tr("with texture coordinates") : tr("without texture coordinates")};
    if (statistics.nonManifoldEdges > 0)
        parts += tr("%n non-manifold edges", nullptr, static_cast<int>(statistics.nonManifoldEdges));
    m_surface->setText(parts.join(QStringLiteral("\n")));
}

} // namespace quadrille

#include "moc_characterpage.cpp"

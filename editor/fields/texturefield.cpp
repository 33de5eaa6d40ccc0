// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/texturefield.h"

#include <QEvent>
#include <QFileDialog>
#include <QMenu>

namespace quadrille {

TextureField::TextureField(QWidget* parent) : ElidedButton(parent)
{
    setMenu(new QMenu(this));
    makeMenu();
}

void TextureField::setTexture(const TextureReference& texture, const QString& without)
{
    m_texture = texture;
    const QString first = texture.paths.empty() ? QString() : QString::fromStdString(texture.paths.front());
    const QString name = QFileInfo(first).fileName();
    switch (texture.kind) {
    case TextureReference::Kind::None:
        setText(without);
        break;
    case TextureReference::Kind::Single:
        setText(name);
        break;
    case TextureReference::Kind::PerFrame:
        setText(tr("%1, one per frame").arg(name));
        break;
    case TextureReference::Kind::PerMaterial:
        setText(tr("%n, by material", nullptr, static_cast<int>(texture.paths.size())));
        break;
    }
    setToolTip(first);
}

void TextureField::makeMenu()
{
    menu()->clear();
    menu()->addAction(tr("One picture…"), this, [this] { choose(false); });
    menu()->addAction(tr("A folder with one picture per frame…"), this, [this] { choose(true); });
    menu()->addAction(tr("None named"), this, [this] { emit chosen({}); });
}

void TextureField::choose(bool isFolder)
{
    const QString start = m_texture.paths.empty()
                              ? m_startFolder
                              : QFileInfo(QString::fromStdString(m_texture.paths.front())).path();
    const QString path =
        isFolder ? QFileDialog::getExistingDirectory(this, tr("Folder with one picture per frame"), start)
                 : QFileDialog::getOpenFileName(this, tr("Texture"), start,
                                                tr("Pictures (*.png *.jpg *.jpeg *.tif *.tiff)"));
    if (path.isEmpty())
        return;
    TextureReference texture;
    texture.kind = isFolder ? TextureReference::Kind::PerFrame : TextureReference::Kind::Single;
    texture.paths = {path.toStdString()};
    emit chosen(texture);
}

void TextureField::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        makeMenu();
    ElidedButton::changeEvent(event);
}

} // namespace quadrille

#include "moc_texturefield.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"
#include "widgets/controls/elidedbutton.h"

namespace quadrille {

/// Says which textures a character or sequence has, and lets others be chosen.
class TextureField : public widgets::ElidedButton
{
    Q_OBJECT

public:
    explicit TextureField(QWidget* parent = nullptr);

    /// \param without what stands there when no textures are named.
    void setTexture(const TextureReference& texture, const QString& without);
    /// Where looking for pictures begins while none are named.
    void setStartFolder(const QString& folder) { m_startFolder = folder; }

signals:
    /// The user chose a picture, a folder, or none: a reference without paths. The field still shows what it
    /// did.
    void chosen(const quadrille::TextureReference& texture);

protected:
    void changeEvent(QEvent* event) override;

private:
    void choose(bool isFolder);
    void makeMenu();

    TextureReference m_texture;
    QString m_startFolder;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/appearance/componentpictures.h"
#include "editor/workspaces/appearance/showntexture.h"

#include <QListWidget>

class QLabel;

namespace quadrille {

/// A list of pictures that takes the arrows for itself, which step through frames elsewhere.
class ComponentGallery : public QListWidget
{
    Q_OBJECT

protected:
    bool event(QEvent* event) override;
};

/// The components of a model as a gallery: choosing one shows it large.
class ComponentsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ComponentsPanel(ShownTexture& shown, QWidget* parent = nullptr);

private:
    QListWidget* addGallery(const char* name, ShownTexture::Space space);
    void retranslate();
    void refresh();
    void take(const std::vector<ComponentPicture>& pictures);
    void showChoice();

    ShownTexture& m_shown;
    QLabel* m_empty;
    QLabel* m_texturesTitle;
    QLabel* m_warpsTitle;
    QListWidget* m_textures = nullptr;
    QListWidget* m_warps = nullptr;
    OpenedAppearancePointer m_drawn; ///< whose pictures there are, or are on their way
    bool m_isShowing = false;
};

} // namespace quadrille

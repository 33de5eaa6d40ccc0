// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/appearance/componentpictures.h"
#include "editor/workspaces/appearance/showntexture.h"

#include <QPointer>
#include <QWidget>

class QLabel;
class QListWidget;

namespace quadrille {

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

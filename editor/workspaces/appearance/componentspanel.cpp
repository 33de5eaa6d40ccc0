// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/componentspanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/ownkeys.h"
#include "editor/language/retranslate.h"

#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QScopedValueRollback>
#include <QVBoxLayout>

namespace quadrille {

namespace {

constexpr int thumbnailSide = 84; // logical pixels
constexpr int galleryMargin = 12;
constexpr double percent = 100;

} // namespace

bool ComponentGallery::event(QEvent* event)
{
    return takesOwnKeys(*event,
                        {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Home, Qt::Key_End}) ||
           QListWidget::event(event);
}

ComponentsPanel::ComponentsPanel(ShownTexture& shown, QWidget* parent)
    : QWidget(parent)
    , m_shown(shown)
    , m_empty(new QLabel)
    , m_texturesTitle(new QLabel)
    , m_warpsTitle(new QLabel)
{
    setObjectName(QStringLiteral("componentsPanel"));
    m_empty->setObjectName(QStringLiteral("componentsEmpty"));
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_textures = addGallery("eigenTextures", ShownTexture::Space::Textures);
    m_warps = addGallery("eigenWarps", ShownTexture::Space::Warps);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(galleryMargin, galleryMargin / 2, galleryMargin, galleryMargin);
    column->addWidget(m_empty);
    column->addWidget(m_texturesTitle);
    column->addWidget(m_textures, 2);
    column->addWidget(m_warpsTitle);
    column->addWidget(m_warps, 1);
    column->addStretch();
    connect(&shown, &ShownTexture::changed, this, &ComponentsPanel::refresh);
    retranslates(this, [this] { retranslate(); });
}

QListWidget* ComponentsPanel::addGallery(const char* name, ShownTexture::Space space)
{
    auto* gallery = new ComponentGallery;
    gallery->setObjectName(QLatin1String(name));
    gallery->setViewMode(QListView::IconMode);
    gallery->setResizeMode(QListView::Adjust);
    gallery->setMovement(QListView::Static);
    gallery->setUniformItemSizes(true);
    gallery->setIconSize({thumbnailSide, thumbnailSide});
    gallery->setSpacing(2);
    gallery->setMinimumHeight(thumbnailSide);
    connect(gallery, &QListWidget::currentRowChanged, this, [this, space](int row) {
        if (m_isShowing || row < 0)
            return;
        m_shown.setMode(TextureMode::Difference);
        m_shown.showComponent({space, row});
    });
    return gallery;
}

void ComponentsPanel::retranslate()
{
    m_texturesTitle->setText(tr("Eigen textures"));
    m_texturesTitle->setToolTip(tr("Which colours change together: above grey more, below it less"));
    m_warpsTitle->setText(tr("Eigen warps"));
    m_warpsTitle->setToolTip(tr(
        "Where texels move together: arrows and colours say which way, their length and strength how far"));
    m_textures->setAccessibleName(m_texturesTitle->text());
    m_warps->setAccessibleName(m_warpsTitle->text());
    m_textures->setToolTip(m_texturesTitle->toolTip());
    m_warps->setToolTip(m_warpsTitle->toolTip());
    m_drawn.reset();
    refresh();
}

/// Pictures are drawn when there is another model.
void ComponentsPanel::refresh()
{
    const auto opened = m_shown.appearance().opened();
    if (opened == m_drawn && opened != nullptr) {
        showChoice();
        return;
    }
    const bool isSameModel =
        opened != nullptr && m_drawn != nullptr && opened->known.model == m_drawn->known.model;
    m_drawn = opened;
    if (isSameModel)
        return;
    take({});
    m_empty->setText(opened == nullptr
                         ? tr("Eigen textures and Eigen warps stand here once the model is built.")
                         : tr("Drawing components…"));
    if (opened == nullptr)
        return;
    const int side = static_cast<int>(thumbnailSide * devicePixelRatioF());
    m_shown.appearance().context().jobs.start(
        {.name = tr("Drawing components"),
         .receiver = this,
         .stillStands =
             [this, opened] { return m_drawn != nullptr && m_drawn->known.model == opened->known.model; },
         .background = true},
        [opened, side](const Progress& progress) {
            return componentPictures(opened->decoder->model(), side, progress);
        },
        [this](const std::vector<ComponentPicture>& pictures) { take(pictures); });
}

void ComponentsPanel::take(const std::vector<ComponentPicture>& pictures)
{
    const QScopedValueRollback showing(m_isShowing, true);
    m_textures->clear();
    m_warps->clear();
    for (const ComponentPicture& each : pictures) {
        QPixmap pixmap = QPixmap::fromImage(each.picture);
        pixmap.setDevicePixelRatio(devicePixelRatioF());
        const double share = percent * each.share;
        const QString text = tr("%1 · %2 %", "number and share of the variance")
                                 .arg(each.index + 1)
                                 .arg(QLocale().toString(share, 'f', share < 10 ? 1 : 0));
        new QListWidgetItem(QIcon(pixmap), text, each.isWarp ? m_warps : m_textures);
    }
    m_empty->setVisible(pictures.empty());
    for (QWidget* widget : std::initializer_list<QWidget*>{m_texturesTitle, m_textures})
        widget->setVisible(!pictures.empty());
    for (QWidget* widget : std::initializer_list<QWidget*>{m_warpsTitle, m_warps})
        widget->setVisible(m_warps->count() > 0);
    showChoice();
}

void ComponentsPanel::showChoice()
{
    const QScopedValueRollback showing(m_isShowing, true);
    const bool isShown = m_shown.content() == TextureContent::Component;
    const ShownTexture::Component& component = m_shown.component();
    const auto choose = [&](QListWidget& gallery, ShownTexture::Space space) {
        gallery.setCurrentRow(isShown && component.space == space ? component.index : -1);
    };
    choose(*m_textures, ShownTexture::Space::Textures);
    choose(*m_warps, ShownTexture::Space::Warps);
}

} // namespace quadrille

#include "moc_componentspanel.cpp"

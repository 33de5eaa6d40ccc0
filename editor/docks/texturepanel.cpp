// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/docks/texturepanel.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/errors/errortext.h"
#include "editor/fields/texturefield.h"
#include "editor/language/retranslate.h"
#include "editor/pictures/uvedges.h"
#include "editor/playback/clipscene.h"
#include "widgets/controls/elidedlabel.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/icons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <utility>

namespace quadrille {

using widgets::MessageStrip;
using widgets::TexturePicture;
using widgets::TextureView;

namespace {

constexpr int rowHeight = 28;    // pixels
constexpr int choiceWidth = 180; // pixels; a texture's name may stand on the button

} // namespace

TexturePanel::TexturePanel(EditorContext& context, ClipScene& scene, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_scene(scene)
    , m_preparing(nullptr, 1)
    , m_view(new TextureView)
    , m_materials(new QComboBox)
    , m_edgesShown(new QCheckBox)
    , m_zoom(new QLabel)
    , m_actualSize(new QToolButton)
    , m_fit(new QToolButton)
    , m_note(new MessageStrip)
    , m_choice(new TextureField)
    , m_file(new QLabel)
    , m_facts(new widgets::ElidedLabel)
    , m_pointer(new widgets::ElidedLabel)
{
    arrangeWidgets();
    connect(&scene, &ClipScene::changed, this, &TexturePanel::refresh);
    connect(&scene, &ClipScene::frameLoaded, this, [this](const QString& name) {
        if (name == m_context.selection.shownSequence())
            refresh();
    });
    connect(&context.selection, &Selection::changed, this, &TexturePanel::refresh);
    connect(&context.media, &SequenceMedia::changed, this, &TexturePanel::refresh);
    connect(m_materials, &QComboBox::currentIndexChanged, this, &TexturePanel::refresh);
    connect(m_edgesShown, &QCheckBox::toggled, this, &TexturePanel::refresh);
    connect(m_fit, &QToolButton::clicked, m_view, &TextureView::fit);
    connect(m_actualSize, &QToolButton::clicked, m_view, &TextureView::showActualSize);
    connect(m_choice, &TextureField::chosen, this, [this](const TextureReference& texture) {
        setSequenceTexture(m_context.document, m_name, texture);
    });
    connect(m_note, &MessageStrip::actionTriggered, this,
            [this] { m_choice->menu()->popup(m_note->mapToGlobal(m_note->rect().bottomLeft())); });
    connect(m_view, &TextureView::zoomChanged, this, [this](double zoom) {
        const double percent = zoom * 100;
        m_zoom->setText(tr("%1 %").arg(QLocale().toString(percent, 'f', percent < 10 ? 1 : 0)));
    });
    connect(m_view, &TextureView::hovered, this, [this](const QPointF& uv, const QPoint& pixel) {
        const auto coordinate = [](double value) { return QLocale().toString(value, 'f', 4); };
        const QString place = tr("u %1  v %2").arg(coordinate(uv.x()), coordinate(uv.y()));
        m_pointer->setText(m_view->image().isNull()
                               ? place
                               : tr("%1 · pixel %2, %3").arg(place).arg(pixel.x()).arg(pixel.y()));
    });
    connect(m_view, &TextureView::hoverEnded, m_pointer, &widgets::ElidedLabel::clear);
    retranslates(this, [this] { retranslate(); });
}

TexturePanel::~TexturePanel() = default;

void TexturePanel::arrangeWidgets()
{
    setObjectName(QStringLiteral("texturePanel"));
    m_materials->setObjectName(QStringLiteral("textureMaterial"));
    m_materials->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_edgesShown->setObjectName(QStringLiteral("textureEdges"));
    m_edgesShown->setMinimumHeight(rowHeight);
    m_zoom->setObjectName(QStringLiteral("textureZoom"));
    m_actualSize->setObjectName(QStringLiteral("textureActualSize"));
    m_fit->setObjectName(QStringLiteral("textureFit"));
    m_fit->setIcon(widgets::icons::icon(QStringLiteral("frameall")));
    m_note->setObjectName(QStringLiteral("textureNote"));
    m_choice->setObjectName(QStringLiteral("textureChoice"));
    m_choice->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    m_choice->setMinimumWidth(choiceWidth);
    m_file->setObjectName(QStringLiteral("textureFile"));
    m_facts->setObjectName(QStringLiteral("textureFacts"));
    m_pointer->setObjectName(QStringLiteral("texturePointer"));
    for (QToolButton* button : {m_actualSize, m_fit}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
    }
    for (QWidget* label :
         {static_cast<QWidget*>(m_file), static_cast<QWidget*>(m_facts), static_cast<QWidget*>(m_pointer)}) {
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        label->setFont(widgets::Theme::tabularFont(font()));
    }
    m_zoom->setFont(widgets::Theme::tabularFont(font()));
    m_file->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_facts->setForegroundRole(QPalette::PlaceholderText);
    m_pointer->setForegroundRole(QPalette::PlaceholderText);
    m_view->setEmptyAction(m_choice);

    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(12, 4, 8, 4);
    tools->setSpacing(4);
    tools->addWidget(m_edgesShown);
    tools->addStretch(1);
    tools->addWidget(m_zoom);
    tools->addWidget(m_actualSize);
    tools->addWidget(m_fit);
    auto* materials = new QHBoxLayout;
    materials->setContentsMargins(12, 0, 12, 4);
    materials->addWidget(m_materials, 1);
    auto* facts = new QVBoxLayout;
    facts->setContentsMargins(12, 4, 12, 8);
    facts->setSpacing(0);
    facts->addWidget(m_file);
    facts->addWidget(m_facts);
    facts->addWidget(m_pointer);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(tools);
    column->addLayout(materials);
    column->addWidget(m_note);
    column->addWidget(m_view, 1);
    column->addLayout(facts);
}

void TexturePanel::retranslate()
{
    m_edgesShown->setText(tr("UV edges"));
    m_edgesShown->setToolTip(tr("Draw the edges of the mesh over its texture"));
    m_actualSize->setText(tr("1:1"));
    m_actualSize->setToolTip(tr("One pixel of the texture for each pixel of the screen (0)"));
    m_actualSize->setAccessibleName(tr("Actual size"));
    m_fit->setToolTip(tr("Fit into the view (F)"));
    m_fit->setAccessibleName(tr("Fit into the view"));
    m_materials->setToolTip(tr("Material whose texture is shown"));
    m_materials->setAccessibleName(tr("Material"));
    m_choice->setAccessibleName(tr("Choose textures"));
    m_zoom->setAccessibleName(tr("Zoom"));
    m_view->setAccessibleName(tr("Texture"));
    m_wanted = {};
    refresh();
}

void TexturePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refresh();
}

void TexturePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    showFile();
}

int TexturePanel::material() const
{
    return std::max(0, m_materials->currentIndex());
}

void TexturePanel::refresh()
{
    if (!isVisible())
        return;
    const QString name = m_context.selection.shownSequence();
    const bool isOther = std::exchange(m_name, name) != name;
    const MeshSequence* sequence = m_scene.sequenceOf(name);
    const LoadedFrame* loaded = m_scene.loadedFrame(name);
    if (const SequenceEntry* entry = m_context.document.sequence(name))
        m_choice->setTexture(entry->texture, tr("Choose textures"));
    refreshMaterials(sequence);
    refreshEdges(sequence);
    // While a frame is read the one before it stays.
    if (sequence != nullptr && loaded != nullptr)
        showTexture(*sequence, *loaded);
    else if (sequence == nullptr || isOther)
        showNothing(stateText(), false);
    showNote();
    showTools();
}

void TexturePanel::refreshMaterials(const MeshSequence* sequence)
{
    QStringList names;
    if (sequence != nullptr && sequence->textures.kind() == TextureSet::Kind::PerMaterial) {
        for (const std::string& material : sequence->topology->data().materials)
            names += QString::fromStdString(material);
    }
    m_materials->setVisible(names.size() > 1);
    QStringList shown;
    for (int i = 0; i < m_materials->count(); ++i)
        shown += m_materials->itemText(i);
    if (names == shown)
        return;
    const QSignalBlocker quiet(m_materials);
    const QString chosen = m_materials->currentText();
    m_materials->clear();
    m_materials->addItems(names);
    m_materials->setCurrentIndex(static_cast<int>(std::max<qsizetype>(0, names.indexOf(chosen))));
}

void TexturePanel::refreshEdges(const MeshSequence* sequence)
{
    const bool hasUvs = sequence != nullptr && sequence->topology->hasUvs();
    m_edgesShown->setEnabled(hasUvs);
    if (hasUvs && m_edgesShown->isChecked()) {
        const std::optional<int> material =
            m_materials->count() > 0 ? std::optional(this->material()) : std::nullopt;
        if (m_edgesOf.lock() != sequence->topology || m_edgesMaterial != material) {
            m_edges.clear();
            m_edgesOf = sequence->topology;
            m_edgesMaterial = material;
            m_context.jobs.start(
                {.name = tr("Drawing the UV edges of “%1”").arg(m_name),
                 .receiver = this,
                 .stillStands =
                     [this, topology = sequence->topology, material] {
                         return m_edgesOf.lock() == topology && m_edgesMaterial == material;
                     },
                 .background = true},
                [topology = sequence->topology, material](const Progress& progress) {
                    return uvEdges(*topology, material, progress);
                },
                [this](const QList<QLineF>& edges) {
                    m_edges = edges;
                    refresh();
                });
        }
        if (!m_edges.isSharedWith(m_view->uvEdges()))
            m_view->setUvEdges(m_edges);
    } else if (!m_view->uvEdges().isEmpty()) {
        m_view->setUvEdges({});
    }
}

void TexturePanel::showTexture(const MeshSequence& sequence, const LoadedFrame& loaded)
{
    const auto index = static_cast<std::size_t>(material());
    if (loaded.error) {
        const ErrorText text = describe(*loaded.error);
        showNothing(text.oneLine(), true);
    } else if (index >= loaded.textures.size() || loaded.textures[index].second.isNull()) {
        showNothing(missingText(sequence), sequence.textures.kind() == TextureSet::Kind::None);
    } else {
        const auto& [texture, image] = loaded.textures[index];
        const QString path =
            toQString(sequence.textures.textures().at(static_cast<std::size_t>(texture)).file);
        const QString frames = sequence.textures.kind() == TextureSet::Kind::PerFrame
                                   ? tr("frame %1").arg(loaded.frame.value)
                                   : tr("all frames");
        prepare({image, path.isEmpty() ? tr("Inside the sequence’s file") : QFileInfo(path).fileName(), path,
                 tr("%1 × %2 pixels · %3").arg(image.width()).arg(image.height()).arg(frames)});
    }
}

/// What is to be said where a sequence cannot be shown (yet).
QString TexturePanel::stateText() const
{
    const SequenceMedia::State* resultState = m_context.media.resultState(m_name);
    if (resultState == nullptr)
        return tr("The texture of the selected sequence is shown here.");
    if (resultState->phase == ResultPhase::Failed)
        return tr("“%1” cannot be shown.").arg(m_name);
    return tr("Opening “%1”…").arg(m_name);
}

QString TexturePanel::missingText(const MeshSequence& sequence) const
{
    if (sequence.textures.kind() == TextureSet::Kind::PerMaterial)
        return tr("The material “%1” has no texture.").arg(m_materials->currentText());
    if (sequence.topology->hasUvs())
        return tr("“%1” has no texture. Choose a picture for all frames, or a folder with one for each.")
            .arg(m_name);
    return tr("“%1” has no texture, and its mesh has no texture coordinates (UVs) to put one on. Choose a "
              "character whose mesh has them in the properties.")
        .arg(m_name);
}

void TexturePanel::showNothing(const QString& reason, bool offersTextures)
{
    m_wanted = {};
    m_isLate = false;
    m_view->setPicture({});
    m_view->setEmptyText(reason);
    m_choice->setVisible(offersTextures);
    m_fileName.clear();
    m_facts->clear();
    showFile();
}

void TexturePanel::prepare(Shown shown)
{
    const bool isSame =
        shown.image.constBits() == m_wanted.image.constBits() && shown.facts == m_wanted.facts;
    if (isSame)
        return;
    m_wanted = std::move(shown);
    m_isLate = m_job != nullptr;
    if (m_isLate)
        return;
    m_job = m_preparing.start(
        {.name = {},
         .receiver = this,
         .stillStands = [this] { return !m_wanted.image.isNull(); },
         .failed =
             [this, shown = m_wanted](const Error&) {
                 show(shown, {shown.image, {}});
             }},
        [image = m_wanted.image](const Progress&) { return widgets::prepareTexture(image); },
        [this, shown = m_wanted](TexturePicture picture) { show(shown, std::move(picture)); });
    connect(m_job, &Job::ended, this, [this] {
        m_job = nullptr;
        if (std::exchange(m_isLate, false))
            prepare(std::exchange(m_wanted, {}));
    });
}

void TexturePanel::show(const Shown& shown, TexturePicture picture)
{
    m_view->setPicture(std::move(picture));
    m_fileName = shown.file;
    m_file->setToolTip(shown.path);
    m_facts->setText(shown.facts);
    showFile();
    showNote();
    showTools();
}

void TexturePanel::showFile()
{
    m_file->setText(fontMetrics().elidedText(m_fileName, Qt::ElideMiddle, std::max(40, width() - 24)));
    if (m_fileName.isEmpty())
        m_file->setToolTip({});
}

/// What works on the view rests while there is nothing in it.
void TexturePanel::showTools()
{
    for (QWidget* tool : std::initializer_list<QWidget*>{m_zoom, m_actualSize, m_fit})
        tool->setVisible(!m_view->isEmpty());
}

/// Says what is missing while something is shown nevertheless.
void TexturePanel::showNote()
{
    const MeshSequence* sequence = m_scene.sequenceOf(m_name);
    const bool hasImage = !m_view->image().isNull();
    if (sequence != nullptr && hasImage && !sequence->topology->hasUvs()) {
        m_note->show(MessageStrip::Kind::Info,
                     tr("The mesh has no texture coordinates (UVs), so it is shown in clay."),
                     tr("Choose a character whose mesh has them in the properties."));
        m_note->setAction({});
    } else if (sequence != nullptr && !hasImage && !m_view->uvEdges().isEmpty()) {
        m_note->show(MessageStrip::Kind::Info, missingText(*sequence));
        m_note->setAction(m_choice->isVisibleTo(m_choice->parentWidget()) ? tr("Choose…") : QString());
    } else {
        m_note->clear();
    }
}

} // namespace quadrille

#include "moc_texturepanel.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/exporting/exportdialog.h"

#include "editor/context/editorcontext.h"
#include "editor/documents/projectpaths.h"
#include "editor/exporting/picturefields.h"
#include "editor/fields/axesfields.h"
#include "editor/fields/clipchoice.h"
#include "editor/fields/numberfield.h"
#include "editor/fields/rangefield.h"
#include "editor/language/retranslate.h"
#include "editor/pictures/takepreview.h"
#include "model/project/exports/exportentry.h"
#include "model/project/fields/pictureoptions.h"
#include "model/sequence/io/playerformat.h"
#include "model/sequence/io/registry.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/icons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace quadrille {

ExportDialog::ExportDialog(EditorContext& context, ExportPlan plan, Seen seen, QWidget* parent)
    : QDialog(parent)
    , m_context(context)
    , m_plan(std::move(plan))
    , m_seen(std::move(seen))
    , m_ownPath(m_plan.edited.isEmpty() ? std::string() : m_plan.entry.path)
    , m_proposedPath(m_plan.edited.isEmpty() ? m_plan.entry.path : std::string())
    , m_strip(new widgets::MessageStrip)
    , m_preview(new TakePreview(context.jobs))
    , m_fields(new QWidget)
    , m_form(new QFormLayout)
    , m_clip(new QComboBox)
    , m_format(new QComboBox)
    , m_place(new QLineEdit)
    , m_choosePlace(new QToolButton)
    , m_files(new QLabel)
    , m_range(new RangeField("export"))
    , m_fps(makeNumberField(rateLook("export.fps")))
    , m_axes(new AxesFields(true))
    , m_textures(new QCheckBox)
    , m_picture(new PictureFields)
    , m_keep(new QCheckBox)
    , m_progress(new QProgressBar)
    , m_export(new QPushButton)
    , m_cancel(new QPushButton)
{
    setObjectName(QStringLiteral("exportDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(820, 560);
    makeControls();
    connectAll();
    retranslates(this, [this] { retranslate(); });
    if (m_plan.isPicture() && m_plan.edited.isEmpty()) {
        takeView();
        m_plan.entry.picture = picture();
    }
    showPlan();
}

void ExportDialog::makeControls()
{
    const auto name = [](QWidget* widget, const char* text) { widget->setObjectName(QLatin1String(text)); };
    name(m_clip, "exportClip");
    name(m_format, "exportFormat");
    name(m_place, "exportPlace");
    name(m_choosePlace, "exportChoosePlace");
    name(m_files, "exportFiles");
    name(m_fps, "exportFps");
    name(m_axes, "exportAxes");
    name(m_textures, "exportTextures");
    name(m_keep, "exportKeep");
    name(m_progress, "exportProgress");
    name(m_strip, "exportMessage");
    name(m_export, "exportAccept");
    name(m_cancel, "exportCancel");
    listClips(*m_clip, m_context.document.project(), m_plan.clips);
    m_clip->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_clip->setEnabled(m_plan.clips.size() == 1);
    m_choosePlace->setIcon(widgets::icons::icon(QStringLiteral("folder")));
    m_files->setWordWrap(true);
    m_files->setForegroundRole(QPalette::PlaceholderText);
    m_keep->setChecked(m_plan.isKept);
    m_keep->setVisible(m_plan.edited.isEmpty());
    m_export->setDefault(true);
    m_progress->setRange(0, 1000);
    QSizePolicy keepsRoom = m_progress->sizePolicy(); // the dialog must not grow when it comes
    keepsRoom.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(keepsRoom);
    m_progress->hide();

    auto* place = new QHBoxLayout;
    place->setSpacing(4);
    place->addWidget(m_place, 1);
    place->addWidget(m_choosePlace);
    m_form->setSpacing(8);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->addRow(new QLabel, m_clip);
    m_form->addRow(new QLabel, m_format);
    m_form->addRow(new QLabel, place);
    m_form->addRow(QString(), m_files);
    m_form->addRow(new QLabel, m_range);
    m_form->addRow(new QLabel, m_fps);
    m_form->addRow(new QLabel, m_axes);
    m_form->addRow(new QLabel, m_textures);
    auto* left = new QVBoxLayout;
    left->setSpacing(16);
    left->addLayout(m_form);
    left->addWidget(m_keep);
    left->addStretch();
    auto* right = new QVBoxLayout;
    right->setSpacing(16);
    right->addWidget(m_preview);
    right->addWidget(m_picture);
    right->addStretch();
    auto* middle = new QHBoxLayout(m_fields);
    middle->setContentsMargins(0, 0, 0, 0);
    middle->setSpacing(24);
    middle->addLayout(left, 1);
    middle->addLayout(right);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_export);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(16);
    column->addWidget(m_fields, 1);
    column->addWidget(m_strip);
    column->addWidget(m_progress);
    column->addLayout(buttons);
}

void ExportDialog::connectAll()
{
    const auto edited = [this] {
        readControls();
        setBusy(false);
        showFacts();
    };
    connect(m_clip, &QComboBox::activated, this, &ExportDialog::chooseClip);
    connect(m_format, &QComboBox::activated, this, &ExportDialog::chooseFormat);
    connect(m_place, &QLineEdit::textEdited, this, edited);
    connect(m_place, &QLineEdit::editingFinished, this, &ExportDialog::followEnding);
    connect(m_choosePlace, &QToolButton::clicked, this, &ExportDialog::choosePlace);
    connect(m_range, &RangeField::edited, this, edited);
    connect(m_fps, &QDoubleSpinBox::valueChanged, this, edited);
    connect(m_axes, &AxesFields::edited, this, edited);
    connect(m_textures, &QCheckBox::toggled, this, edited);
    connect(m_picture, &PictureFields::viewRequested, this, &ExportDialog::takeView);
    connect(m_strip, &widgets::MessageStrip::actionTriggered, this, &ExportDialog::showInFolder);
    connect(m_picture, &PictureFields::edited, this, edited);
    connect(m_keep, &QCheckBox::toggled, this, [this](bool kept) { m_plan.isKept = kept; });
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_job)
            m_job->cancel();
        else
            reject();
    });
    connect(m_export, &QPushButton::clicked, this, [this] {
        if (m_isDone)
            accept();
        else
            start();
    });
}

void ExportDialog::readControls()
{
    const ProjectSettings& settings = m_context.document.project().settings;
    ExportEntry& entry = m_plan.entry;
    entry.path = m_place->text().toStdString();
    entry.textures = m_textures->isChecked();
    entry.fps = m_fps->value() == settings.fps ? std::nullopt : std::optional(m_fps->value());
    entry.axes = m_axes->axes() == settings.axes ? std::nullopt : std::optional(m_axes->axes());
    if (m_plan.isPlayer()) {
        entry.fps.reset();
        entry.axes.reset();
    }
    const bool isWhole = frameCount() == 0 || isDataSet() || m_plan.clips.size() > 1 || m_plan.isPlayer();
    entry.range = isWhole ? std::nullopt : m_range->range();
    if (m_plan.isPicture())
        entry.picture = picture();
}

UnknownKeys ExportDialog::picture() const
{
    UnknownKeys json = pictureToJson(m_picture->settings());
    if (m_picture->takesKeys()) {
        for (const char* key : {"camera", "revolutions", "view"})
            json.erase(key);
    }
    return json;
}

void ExportDialog::offerFormats()
{
    m_format->clear();
    for (const auto& exporter : exporters()) {
        const FormatInfo& info = exporter->format();
        if (info.id == playerFormat && !isLive())
            continue;
        m_format->addItem(QString::fromStdString(info.name + " (" + info.extensions.front() + ")"),
                          QString::fromStdString(info.id));
    }
}

void ExportDialog::showPlan()
{
    const ProjectSettings& settings = m_context.document.project().settings;
    const ExportEntry& entry = m_plan.entry;
    const QSignalBlocker blocks[] = {QSignalBlocker(m_fps), QSignalBlocker(m_textures),
                                     QSignalBlocker(m_format)};
    offerFormats();
    m_clip->setCurrentIndex(m_clip->findData(m_plan.clips.front()));
    m_format->setCurrentIndex(m_format->findData(QString::fromStdString(m_plan.format().id)));
    m_place->setText(QString::fromStdString(entry.path));
    m_range->setRange(entry.range, frameCount());
    m_range->setEnabled(m_plan.clips.size() == 1 && !isDataSet() && frameCount() > 0 && !m_plan.isPlayer());
    m_fps->setEnabled(!m_plan.isPlayer());
    m_fps->setValue(entry.fps.value_or(settings.fps));
    m_axes->setProjectAxes(settings.axes);
    m_axes->setAxes(entry.axes.value_or(settings.axes));
    m_textures->setChecked(entry.textures);
    if (!entry.picture.isNone()) {
        ProjectProblems ignored;
        m_picture->setSettings(pictureFromJson(entry.picture, "/picture", ignored));
    }
    const AnimationEntry* animation = m_context.document.animation(nameOfClip(m_plan.clips.front()));
    const bool hasKeys = animation != nullptr && !animation->camera.empty() &&
                         m_plan.clips.front().startsWith(QLatin1String("animations/"));
    m_picture->setKeysPossible(hasKeys, hasKeys && !entry.picture.contains("camera"));
    const bool isSeen = sequence() != nullptr && m_seen(nameOfClip(m_plan.clips.front()), *sequence());
    m_picture->setViewPossible(isSeen || m_picture->settings().view, m_picture->settings().view.has_value());
    showFacts();
}

void ExportDialog::chooseFormat()
{
    readControls();
    const std::string before = m_plan.entry.name;
    const bool hasOwnName = !m_plan.edited.isEmpty();
    m_plan.entry.format = m_format->currentData().toString().toStdString();
    const ExportPlan fresh = planExport(m_plan.clips, m_plan.entry.format, folder());
    m_plan.entry.name = hasOwnName ? before : fresh.entry.name;
    if (m_plan.entry.path == m_proposedPath)
        m_plan.entry.path = m_proposedPath = fresh.entry.path;
    else
        m_plan.entry.path = withEndingOf(m_plan.entry.path, m_plan.format());
    if (m_plan.isPicture() && m_plan.entry.picture.isNone() && m_plan.edited.isEmpty())
        takeView();
    m_plan.entry.picture = m_plan.isPicture() ? picture() : UnknownKeys();
    showPlan();
}

QString ExportDialog::folder() const
{
    return toQString(std::filesystem::path(m_plan.entry.path).parent_path());
}

void ExportDialog::followEnding()
{
    const std::string ending = std::filesystem::path(m_place->text().toStdString()).extension().string();
    const auto hasEnding = [&](const FormatInfo& info) {
        return std::ranges::find(info.extensions, ending) != info.extensions.end();
    };
    if (ending.empty() || hasEnding(m_plan.format()))
        return;
    for (const auto& exporter : exporters()) {
        const int item = m_format->findData(QString::fromStdString(exporter->format().id));
        if (item < 0 || !hasEnding(exporter->format()))
            continue;
        m_format->setCurrentIndex(item);
        chooseFormat();
        return;
    }
}

void ExportDialog::chooseClip()
{
    readControls();
    m_plan.clips = {m_clip->currentData().toString()};
    if (m_plan.isPlayer() && !isLive())
        m_plan.entry.format = exporters().front()->format().id;
    m_plan.entry.range.reset();
    m_view.reset();
    if (m_plan.edited.isEmpty()) {
        const ExportPlan fresh = planExport(m_plan.clips, m_plan.format().id, folder());
        m_plan.entry.name = fresh.entry.name;
        m_plan.entry.path = m_proposedPath = fresh.entry.path;
    }
    if (m_plan.isPicture()) {
        RenderSettings settings = m_picture->settings();
        settings.view.reset();
        m_picture->setSettings(settings);
        takeView();
        m_plan.entry.picture = picture();
    }
    showPlan();
}

void ExportDialog::takeView()
{
    const MeshSequence* clip = m_plan.clips.size() == 1 ? sequence() : nullptr;
    m_view = clip == nullptr ? std::nullopt : m_seen(nameOfClip(m_plan.clips.front()), *clip);
    if (!m_view)
        return;
    RenderSettings settings = m_picture->settings();
    settings.view = m_view->camera;
    if (m_plan.entry.picture.isNone())
        settings.camera = m_view->follows ? CameraMode::Follow : CameraMode::Fixed;
    m_picture->setSettings(settings);
}

void ExportDialog::choosePlace()
{
    const FormatInfo& info = m_plan.format();
    const QString ending = QString::fromStdString(info.extensions.front());
    QString file = QFileDialog::getSaveFileName(this, tr("Export to"), m_place->text(),
                                                QString::fromStdString(info.name) + " (*" + ending + ")",
                                                nullptr, QFileDialog::DontConfirmOverwrite);
    if (file.isEmpty())
        return;
    if (!file.endsWith(ending))
        file += ending;
    m_place->setText(file);
    readControls();
    showFacts();
}

} // namespace quadrille

#include "moc_exportdialog.cpp"

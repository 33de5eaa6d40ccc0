// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/exporting/picturefields.h"

#include "editor/language/retranslate.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QStandardItemModel>

namespace quadrille {

namespace {

constexpr int largestSide = 8192;
/// Of the camera that goes along keys, behind the modes.
constexpr int keysIndex = 3;

} // namespace

PictureFields::PictureFields(QWidget* parent)
    : QWidget(parent)
    , m_form(new QFormLayout(this))
    , m_width(new QSpinBox)
    , m_height(new QSpinBox)
    , m_background(new QComboBox)
    , m_shading(new QComboBox)
    , m_camera(new QComboBox)
    , m_turns(new QDoubleSpinBox)
    , m_view(new QCheckBox)
{
    for (QSpinBox* side : {m_width, m_height}) {
        side->setRange(16, largestSide);
        side->setSingleStep(2);
        connect(side, &QSpinBox::valueChanged, this, &PictureFields::edited);
    }
    m_width->setObjectName(QStringLiteral("pictureWidth"));
    m_height->setObjectName(QStringLiteral("pictureHeight"));
    m_background->setObjectName(QStringLiteral("pictureBackground"));
    m_shading->setObjectName(QStringLiteral("pictureShading"));
    m_camera->setObjectName(QStringLiteral("pictureCamera"));
    m_turns->setObjectName(QStringLiteral("pictureTurns"));
    m_turns->setRange(-20, 20);
    m_turns->setSingleStep(0.25);
    m_background->addItems({QString(), QString(), QString()});
    m_shading->addItems({QString(), QString(), QString(), QString()});
    m_camera->addItems({QString(), QString(), QString()});
    auto* size = new QHBoxLayout;
    size->setSpacing(4);
    size->addWidget(m_width, 1);
    size->addWidget(new QLabel(QStringLiteral("×")));
    size->addWidget(m_height, 1);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setSpacing(8);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->addRow(new QLabel, size);
    m_view->setObjectName(QStringLiteral("pictureView"));
    for (QWidget* field : std::initializer_list<QWidget*>{m_background, m_shading, m_camera, m_view, m_turns})
        m_form->addRow(new QLabel, field);
    for (QComboBox* box : {m_background, m_shading, m_camera})
        connect(box, &QComboBox::activated, this, &PictureFields::edited);
    connect(m_camera, &QComboBox::currentIndexChanged, this, [this](int mode) {
        m_turns->setEnabled(mode == static_cast<int>(CameraMode::Turntable));
        m_view->setVisible(mode != keysIndex);
    });
    connect(m_view, &QCheckBox::toggled, this, [this](bool taken) {
        if (taken)
            emit viewRequested();
        else
            m_settings.view.reset();
        emit edited();
    });
    connect(m_turns, &QDoubleSpinBox::valueChanged, this, &PictureFields::edited);
    setSettings({});
    retranslates(this, [this] { retranslate(); });
}

RenderSettings PictureFields::settings() const
{
    RenderSettings settings = m_settings;
    settings.look.width = m_width->value();
    settings.look.height = m_height->value();
    settings.look.background = static_cast<RenderOptions::Background>(m_background->currentIndex());
    settings.look.shading = static_cast<RenderOptions::Shading>(m_shading->currentIndex());
    if (!takesKeys())
        settings.camera = static_cast<CameraMode>(m_camera->currentIndex());
    settings.revolutions = m_turns->value();
    return settings;
}

void PictureFields::setSettings(const RenderSettings& settings)
{
    const QSignalBlocker blocker(this);
    m_settings = settings;
    m_width->setValue(settings.look.width);
    m_height->setValue(settings.look.height);
    m_background->setCurrentIndex(static_cast<int>(settings.look.background));
    m_shading->setCurrentIndex(static_cast<int>(settings.look.shading));
    if (!takesKeys())
        m_camera->setCurrentIndex(static_cast<int>(settings.camera));
    m_turns->setValue(settings.revolutions);
    setViewPossible(m_view->isEnabled() || settings.view, settings.view.has_value());
}

void PictureFields::setViewPossible(bool possible, bool taken)
{
    const QSignalBlocker blocker(m_view);
    m_view->setEnabled(possible);
    m_view->setChecked(possible && taken);
}

bool PictureFields::takesView() const
{
    return m_view->isChecked() && !takesKeys();
}

void PictureFields::setKeysPossible(bool possible, bool taken)
{
    const QSignalBlocker blocker(this);
    if (!possible && m_camera->count() > keysIndex)
        m_camera->removeItem(keysIndex);
    else if (possible && m_camera->count() == keysIndex)
        m_camera->addItem(tr("Goes along its keys"));
    if (possible && taken)
        m_camera->setCurrentIndex(keysIndex);
    else if (m_camera->currentIndex() < 0 || takesKeys())
        m_camera->setCurrentIndex(static_cast<int>(m_settings.camera));
}

bool PictureFields::takesKeys() const
{
    return m_camera->currentIndex() == keysIndex;
}

void PictureFields::setTransparencyPossible(bool possible)
{
    const auto transparent = static_cast<int>(RenderOptions::Background::Transparent);
    auto* items = qobject_cast<QStandardItemModel*>(m_background->model());
    items->item(transparent)->setEnabled(possible);
    if (!possible && m_background->currentIndex() == transparent)
        m_background->setCurrentIndex(static_cast<int>(RenderOptions::Background::Dark));
}

void PictureFields::retranslate()
{
    const QStringList labels{tr("Size"), tr("Background"), tr("Shading"), tr("Camera"), {}, tr("Turns")};
    const QList<QWidget*> fields{m_width, m_background, m_shading, m_camera, m_view, m_turns};
    for (int row = 0; row < labels.size(); ++row) {
        if (labels[row].isEmpty())
            continue;
        auto* label = qobject_cast<QLabel*>(m_form->itemAt(row, QFormLayout::LabelRole)->widget());
        label->setText(labels[row]);
        label->setBuddy(fields[row]);
        fields[row]->setAccessibleName(labels[row]);
    }
    m_height->setAccessibleName(tr("Height"));
    m_width->setSuffix(tr(" px"));
    m_height->setSuffix(tr(" px"));
    const auto name = [](QComboBox& box, const QStringList& texts) {
        for (int i = 0; i < texts.size(); ++i)
            box.setItemText(i, texts[i]);
    };
    name(*m_background, {tr("Light"), tr("Dark"), tr("Transparent")});
    name(*m_shading, {tr("Textured"), tr("Texture without light"), tr("Clay"), tr("Wireframe")});
    name(*m_camera, {tr("Turns around the figure"), tr("Stands still"), tr("Follows the figure")});
    if (m_camera->count() > keysIndex)
        m_camera->setItemText(keysIndex, tr("Goes along its keys"));
    m_view->setText(tr("From where the view looks"));
    m_view->setToolTip(tr("The frame that the view shows looks the same in the film; otherwise the camera "
                          "steps back until the figure fills the picture"));
    m_turns->setToolTip(tr("Full turns of the camera over the clip; negative ones go the other way round"));
}

} // namespace quadrille

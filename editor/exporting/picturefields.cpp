// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/exporting/picturefields.h"

#include <QStandardItemModel>

namespace quadrille {

PictureFields::PictureFields(QWidget* parent)
    : LabelForm(parent)
    , m_fields(*this, [this](const QString& /*text*/, const char* /*property*/, const auto& change) {
        edit(change);
    })
{
    layout()->setContentsMargins(0, 0, 0, 0);
    addLook();
    addCamera();
    setViewPossible(true, false);
    retranslate();
}

void PictureFields::addLook()
{
    using Look = RenderOptions;
    const auto of = [](auto member) { return at(&Picture::settings, &RenderSettings::look, member); };
    NumberLook side{.path = "picture.width", .step = 2, .decimals = 0, .unit = [] { return tr(" px"); }};
    m_fields.addNumber({"pictureWidth", [] { return tr("Width"); }, {}}, of(&Look::width), side);
    side.path = "picture.height";
    m_fields.addNumber({"pictureHeight", [] { return tr("Height"); }, {}}, of(&Look::height), side);
    m_background = m_fields.addChoice(
        {"pictureBackground", [] { return tr("Background"); }, {}}, of(&Look::background),
        {[] { return tr("Light"); }, [] { return tr("Dark"); }, [] { return tr("Transparent"); }});
    m_fields.addChoice({"pictureShading", [] { return tr("Shading"); }, {}}, of(&Look::shading),
                       {[] { return tr("Textured"); }, [] { return tr("Texture without light"); },
                        [] { return tr("Clay"); }, [] { return tr("Wireframe"); }});
}

void PictureFields::addCamera()
{
    using Mode = std::optional<CameraMode>; // nothing: along the keys
    m_fields.addItems(
        {"pictureCamera", [] { return tr("Camera"); }, {}},
        Lens<Picture, Mode>{
            [](const Picture& picture) { return picture.takesKeys ? Mode() : picture.settings.camera; },
            [](Picture& picture, Mode mode) {
                picture.takesKeys = !mode;
                picture.settings.camera = mode.value_or(picture.settings.camera);
            }},
        [this](const Picture& /*picture*/) {
            std::vector<FieldItem<Mode>> items{{tr("Turns around the figure"), CameraMode::Turntable},
                                               {tr("Stands still"), CameraMode::Fixed},
                                               {tr("Follows the figure"), CameraMode::Follow}};
            if (m_hasKeys)
                items.push_back({tr("Goes along its keys"), Mode()});
            return items;
        });
    m_view = m_fields.addSwitch({"pictureView", [] { return tr("From where the view looks"); },
                                 [] {
                                     return tr("The frame that the view shows looks the same in the film; "
                                               "otherwise the camera "
                                               "steps back until the figure fills the picture");
                                 },
                                 [](const Picture& picture) { return !picture.takesKeys; }},
                                &Picture::takesView);
    m_turns = m_fields.addNumber(
        {"pictureTurns", [] { return tr("Turns"); },
         [] { return tr("Full turns of the camera over the clip; negative ones go the other way round"); }},
        at(&Picture::settings, &RenderSettings::revolutions),
        {.path = "picture.revolutions", .step = 0.25, .lowest = -1000});
}

void PictureFields::edit(const std::function<void(Picture&)>& change)
{
    const bool tookView = m_picture.takesView;
    change(m_picture);
    if (m_picture.takesView && !tookView)
        emit viewRequested();
    if (!m_picture.takesView)
        m_picture.settings.view.reset();
    refresh();
    emit edited();
}

void PictureFields::refresh()
{
    m_fields.show(m_picture);
    m_turns->setEnabled(!takesKeys() && m_picture.settings.camera == CameraMode::Turntable);
}

void PictureFields::setSettings(const RenderSettings& settings)
{
    m_picture.settings = settings;
    setViewPossible(m_view->isEnabled() || settings.view, settings.view.has_value());
}

void PictureFields::setViewPossible(bool possible, bool taken)
{
    m_view->setEnabled(possible);
    m_picture.takesView = possible && taken;
    refresh();
}

void PictureFields::setKeysPossible(bool possible, bool taken)
{
    m_hasKeys = possible;
    m_picture.takesKeys = possible && taken;
    refresh();
}

void PictureFields::setTransparencyPossible(bool possible)
{
    using Background = RenderOptions::Background;
    auto* items = qobject_cast<QStandardItemModel*>(m_background->model());
    items->item(static_cast<int>(Background::Transparent))->setEnabled(possible);
    Background& own = m_picture.settings.look.background;
    if (!possible && own == Background::Transparent)
        own = Background::Dark;
    refresh();
}

void PictureFields::retranslate()
{
    m_fields.retranslate();
    refresh();
}

} // namespace quadrille

#include "moc_picturefields.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "model/render/rendersettings.h"

namespace quadrille {

/// How pictures and videos of a clip look: size, background, shading and what the camera does.
class PictureFields : public LabelForm
{
    Q_OBJECT

public:
    explicit PictureFields(QWidget* parent = nullptr);

    const RenderSettings& settings() const { return m_picture.settings; }
    void setSettings(const RenderSettings& settings);
    /// Offers the camera keys of an animation, and takes them or not.
    void setKeysPossible(bool possible, bool taken);
    /// The camera is that of the animation's keys.
    bool takesKeys() const { return m_picture.takesKeys; }
    /// Offers to look from where the view looks, or from where it looked when it was taken.
    /// \param possible the view shows the clip, or a place is known already.
    void setViewPossible(bool possible, bool taken);
    /// The camera begins where the view looks, instead of where it frames the figure.
    bool takesView() const { return m_picture.takesView && !m_picture.takesKeys; }
    /// Video holds no transparency.
    void setTransparencyPossible(bool possible);

signals:
    void edited();
    /// The user wants the place where the view looks now.
    void viewRequested();

protected:
    void retranslate() override;

private:
    struct Picture
    {
        RenderSettings settings;
        bool takesKeys = false; ///< instead of the camera of the settings
        bool takesView = false;
    };

    void addLook();
    void addCamera();
    void edit(const std::function<void(Picture&)>& change);
    void refresh();

    Picture m_picture;
    FieldForm<Picture, LabelForm> m_fields;
    bool m_hasKeys = false;
    QComboBox* m_background = nullptr;
    QCheckBox* m_view = nullptr;
    QDoubleSpinBox* m_turns = nullptr;
};

} // namespace quadrille

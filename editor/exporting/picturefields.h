// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/render/rendersettings.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace quadrille {

/// How pictures and videos of a clip look: size, background, shading and what the camera does.
class PictureFields : public QWidget
{
    Q_OBJECT

public:
    explicit PictureFields(QWidget* parent = nullptr);

    RenderSettings settings() const;
    void setSettings(const RenderSettings& settings);
    /// Offers the camera keys of an animation, and takes them or not.
    void setKeysPossible(bool possible, bool taken);
    /// The camera is that of the animation's keys.
    bool takesKeys() const;
    /// Offers to look from where the view looks, or from where it looked when it was taken.
    /// \param possible the view shows the clip, or a place is known already.
    void setViewPossible(bool possible, bool taken);
    /// The camera begins where the view looks, instead of where it frames the figure.
    bool takesView() const;
    /// Video holds no transparency.
    void setTransparencyPossible(bool possible);

signals:
    void edited();
    /// The user wants the place where the view looks now.
    void viewRequested();

private:
    void retranslate();

    RenderSettings m_settings;
    QFormLayout* m_form;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QComboBox* m_background;
    QComboBox* m_shading;
    QComboBox* m_camera;
    QDoubleSpinBox* m_turns;
    QCheckBox* m_view;
};

} // namespace quadrille

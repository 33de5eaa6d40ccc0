// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/axes.h"

#include <QString>
#include <QWidget>
#include <optional>

class QComboBox;

namespace quadrille {

/// The name of one of the two axes of the ground, in their order in the project. \param which  0 or 1.
QString groundAxisName(UpAxis up, int which);

/// Up axis and unit of coordinates.
class AxesFields : public QWidget
{
    Q_OBJECT

public:
    /// \param offersPrograms with a list of programs and what they expect above.
    explicit AxesFields(bool offersPrograms = false, QWidget* parent = nullptr);

    CoordinateSystem axes() const;
    /// A unit without a name gets an item of its own.
    void setAxes(const CoordinateSystem& axes);
    /// What "As the project" stands for in the list of programs.
    void setProjectAxes(const CoordinateSystem& axes);

signals:
    /// By the user.
    void edited();

private:
    void choosePreset();
    void showPreset();
    void retranslate();

    CoordinateSystem m_projectAxes;
    QComboBox* m_programs = nullptr;
    QComboBox* m_up;
    QComboBox* m_unit;
};

} // namespace quadrille

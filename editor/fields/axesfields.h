// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/axes.h"

#include <QWidget>
#include <optional>

class QComboBox;

namespace quadrille {

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

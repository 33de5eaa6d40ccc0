// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QLocale>
#include <QString>

namespace quadrille::widgets {

/// How long things are in a view whose coordinates are in a project's unit of length, and by which steps they
/// move: metric, or in feet and inches where the unit is one of these.
class Ruler
{
public:
    Ruler() = default;
    /// \param metresPerUnit  of the coordinates, > 0.
    explicit Ruler(double metresPerUnit);

    bool operator==(const Ruler&) const = default;

    double metresPerUnit() const { return m_metresPerUnit; }
    /// A length in metres, in the unit of coordinates.
    float of(float metres) const { return metres / static_cast<float>(m_metresPerUnit); }
    double of(double metres) const { return metres / m_metresPerUnit; }
    bool isImperial() const;

    // The steps that grid, snapping and nudges share, in the unit of coordinates.
    double coarse() const; ///< a metre or a foot
    double middle() const { return coarse() / parts(); }
    double fine() const { return middle() / 10; } ///< a centimetre or a tenth of an inch
    /// How many middle steps make a coarse one: 10 or 12.
    int parts() const { return isImperial() ? 12 : 10; }

    /// The power of ten, in metres, that is next above the unit: 0.01 for centimetres, 1 for feet. What is
    /// usual for metres, divided by it, is usual for the unit.
    double decade() const;
    /// How many decimals show as much of a length as so many do in metres.
    int decimals(int inMetres) const;
    /// A length without what is finer than so many decimals in metres.
    double rounded(double length, int decimalsInMetres) const;

    /// "1.25 m", "3.4 cm" or "7.2 mm", "4.1 ft" or "1.3 in", in the user's number format. \param length  in
    /// the unit of coordinates.
    QString text(double length, const QLocale& locale = QLocale()) const;

private:
    double m_metresPerUnit = 1;
};

} // namespace quadrille::widgets

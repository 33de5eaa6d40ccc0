// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <QWidget>
#include <optional>

class QSpinBox;

namespace quadrille {

/// First and last of the frames of a take that are used.
class RangeField : public QWidget
{
    Q_OBJECT

public:
    /// \param name  object names of both numbers begin with it; they end with "First" and "Last".
    explicit RangeField(const char* name, QWidget* parent = nullptr);

    /// Shows a range; nothing is emitted. \param range  nothing: all. \param frames  of the take; 0 where
    /// that is not known, and nothing can be chosen.
    void setRange(const std::optional<FrameRange>& range, std::int64_t frames);
    /// Nothing where all frames are chosen: they stay all when the take gets longer.
    std::optional<FrameRange> range() const;

signals:
    /// The user chose others.
    void edited();

private:
    void retranslate();

    QSpinBox* m_first;
    QSpinBox* m_last;
};

} // namespace quadrille

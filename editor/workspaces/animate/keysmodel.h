// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/animationentry.h"

#include <QAbstractTableModel>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille {

class CurrentAnimation;
class FramePictures;

/// The keys of the animation that is worked on: when they are wanted, and when they are met.
class KeysModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Pose,
        Wanted,    ///< seconds, editable
        Obtained,  ///< seconds
        Deviation, ///< obtained − wanted, seconds
        Tolerance, ///< seconds, editable; empty: any
        ColumnCount
    };

    KeysModel(CurrentAnimation& animation, FramePictures& pictures, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Edits the animation. A wanted time that another key has becomes the next free one. \param value
    /// seconds; of the tolerance, less than 0 for any.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    /// What the deviations are, for a summary; empty where no key is met yet. Seconds.
    std::vector<double> deviations() const;

private:
    void refresh();
    void tellAll();
    std::optional<double> deviation(std::size_t key) const;
    QVariant text(std::size_t key, int column) const;
    QString tip(std::size_t key, int column) const;
    bool isMissed(std::size_t key) const;

    CurrentAnimation& m_animation;
    FramePictures& m_pictures;
    std::vector<KeyEntry> m_keys;
    std::vector<std::optional<double>> m_obtained; ///< seconds
};

} // namespace quadrille

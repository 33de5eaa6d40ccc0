// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/keysmodel.h"

#include "editor/context/editorcontext.h"
#include "editor/pictures/framepictures.h"
#include "editor/workspaces/animate/animationtracks.h"
#include "editor/workspaces/animate/constraintedits.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "widgets/theme/theme.h"

#include <QIcon>
#include <QLocale>
#include <QPixmap>
#include <cmath>

namespace quadrille {

using widgets::ColorRole;
using widgets::Theme;

namespace {

QString seconds(double value)
{
    return QLocale().toString(value, 'f', 2);
}

} // namespace

KeysModel::KeysModel(CurrentAnimation& animation, FramePictures& pictures, QObject* parent)
    : QAbstractTableModel(parent), m_animation(animation), m_pictures(pictures)
{
    connect(&animation, &CurrentAnimation::changed, this, &KeysModel::refresh);
    connect(&animation, &CurrentAnimation::resultChanged, this, &KeysModel::refresh);
    connect(&pictures, &FramePictures::drawn, this, &KeysModel::tellAll);
    connect(&Theme::instance(), &Theme::changed, this, &KeysModel::tellAll);
    connect(&animation.context().languages, &LanguageManager::changed, this, [this] {
        tellAll();
        emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    });
    refresh();
}

void KeysModel::refresh()
{
    const AnimationEntry* entry = m_animation.entry();
    std::vector<KeyEntry> keys = entry == nullptr ? std::vector<KeyEntry>() : keysOf(*entry);
    const double fps = m_animation.context().document.project().settings.fps;
    std::vector<std::optional<double>> obtained;
    for (const auto& frame : obtainedFrames(keys, m_animation.result().get()))
        obtained.push_back(frame ? std::optional(static_cast<double>(*frame) / fps) : std::nullopt);
    if (keys == m_keys && obtained == m_obtained)
        return;
    const auto before = static_cast<int>(m_keys.size());
    const auto after = static_cast<int>(keys.size());
    // Rows that stay keep their selection and their editors.
    if (after > before)
        beginInsertRows({}, before, after - 1);
    else if (after < before)
        beginRemoveRows({}, after, before - 1);
    m_keys = std::move(keys);
    m_obtained = std::move(obtained);
    if (after > before)
        endInsertRows();
    else if (after < before)
        endRemoveRows();
    tellAll();
}

void KeysModel::tellAll()
{
    if (!m_keys.empty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int KeysModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_keys.size());
}

int KeysModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

Qt::ItemFlags KeysModel::flags(const QModelIndex& index) const
{
    const bool isEditable = index.column() == Wanted || index.column() == Tolerance;
    return QAbstractTableModel::flags(index) | (isEditable ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

std::optional<double> KeysModel::deviation(std::size_t key) const
{
    return m_obtained[key] ? std::optional(*m_obtained[key] - m_keys[key].time) : std::nullopt;
}

bool KeysModel::isMissed(std::size_t key) const
{
    const auto off = deviation(key);
    return off && m_keys[key].tolerance && std::abs(*off) > *m_keys[key].tolerance + 1e-6;
}

std::vector<double> KeysModel::deviations() const
{
    std::vector<double> all;
    for (std::size_t key = 0; key < m_keys.size(); ++key)
        if (const auto off = deviation(key))
            all.push_back(*off);
    return all;
}

QVariant KeysModel::text(std::size_t key, int column) const
{
    const auto off = deviation(key);
    switch (column) {
    case Pose:
        return poseText(m_keys[key].sequence, m_keys[key].frame);
    case Wanted:
        return seconds(m_keys[key].time);
    case Obtained:
        return m_obtained[key] ? seconds(*m_obtained[key]) : QStringLiteral("–");
    case Deviation: {
        if (!off)
            return QStringLiteral("–");
        const QString sign = *off > 0.005 ? QStringLiteral("+") : QString();
        return std::abs(*off) < 0.005 ? seconds(0) : sign + seconds(*off);
    }
    case Tolerance:
        return m_keys[key].tolerance ? seconds(*m_keys[key].tolerance) : tr("any");
    default:
        return {};
    }
}

QString KeysModel::tip(std::size_t key, int column) const
{
    if (column == Wanted || column == Tolerance)
        return tr("F2 or another click edits it, a double click goes there");
    if (isMissed(key))
        return tr("Further off than its tolerance allows");
    return tr("A double click goes there");
}

QVariant KeysModel::data(const QModelIndex& index, int role) const
{
    const auto key = static_cast<std::size_t>(index.row());
    if (!index.isValid() || key >= m_keys.size())
        return {};
    switch (role) {
    case Qt::DisplayRole:
        return text(key, index.column());
    case Qt::EditRole:
        if (index.column() == Wanted)
            return m_keys[key].time;
        if (index.column() == Tolerance)
            return m_keys[key].tolerance.value_or(-1);
        return text(key, index.column());
    case Qt::DecorationRole:
        if (index.column() != Pose)
            return {};
        return QIcon(QPixmap::fromImage(
            m_pictures.picture(QString::fromStdString(m_keys[key].sequence), m_keys[key].frame)));
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignVCenter | (index.column() == Pose ? Qt::AlignLeft : Qt::AlignRight));
    case Qt::ForegroundRole:
        if (isMissed(key) && (index.column() == Obtained || index.column() == Deviation))
            return Theme::color(ColorRole::ErrorText);
        if (index.column() == Obtained || index.column() == Deviation ||
            (index.column() == Tolerance && !m_keys[key].tolerance))
            return Theme::color(ColorRole::TextMuted);
        return {};
    case Qt::ToolTipRole:
        return tip(key, index.column());
    default:
        return {};
    }
}

QVariant KeysModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignVCenter | (section == Pose ? Qt::AlignLeft : Qt::AlignRight));
    if (role == Qt::ToolTipRole) {
        const QStringList tips{tr("The sequence and the frame of it that is to be shown"),
                               tr("When it is to be shown"), tr("When it is shown"),
                               tr("How much later than wanted; below 0 for earlier"),
                               tr("By how much the time may be missed at most")};
        return tips.value(section);
    }
    const QStringList titles{tr("Pose"), tr("Wanted (s)"), tr("Obtained (s)"), tr("Off (s)"),
                             tr("May be off (s)")};
    return role == Qt::DisplayRole ? titles.value(section) : QVariant();
}

bool KeysModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const auto key = static_cast<std::size_t>(index.row());
    if (role != Qt::EditRole || key >= m_keys.size() || !flags(index).testFlag(Qt::ItemIsEditable))
        return false;
    std::vector<KeyEntry> keys = m_keys;
    KeyEntry edited = keys[key];
    const double wanted = value.toDouble();
    if (index.column() == Wanted) {
        std::vector<KeyEntry> others = keys;
        others.erase(others.begin() + index.row());
        edited.time = freeKeyTime(others, wanted, m_animation.context().document.project().settings.fps);
    } else {
        edited.tolerance = wanted < 0 ? std::nullopt : std::optional(wanted);
    }
    if (edited == keys[key])
        return false;
    keys[key] = edited;
    m_animation.edit(index.column() == Wanted ? tr("Move key") : tr("Change the tolerance of a key"),
                     QStringLiteral("keys"), [&](AnimationEntry& entry) { setKeys(entry, std::move(keys)); });
    return true;
}

} // namespace quadrille

#include "moc_keysmodel.cpp"

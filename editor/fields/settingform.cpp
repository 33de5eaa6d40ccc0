// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/settingform.h"

#include "editor/language/retranslate.h"
#include "widgets/theme/icons.h"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cassert>

namespace quadrille {

namespace {

enum Column
{
    LabelColumn,
    FieldColumn,
    ResetColumn,
    ColumnCount
};

constexpr int rowHeight = 24; // pixels

} // namespace

SettingForm::SettingForm(QWidget* parent) : QWidget(parent), m_grid(new QGridLayout)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(m_grid);
    column->addStretch(1);
    m_grid->setContentsMargins(12, 4, 8, 12);
    m_grid->setHorizontalSpacing(8);
    m_grid->setVerticalSpacing(4);
    m_grid->setColumnStretch(FieldColumn, 1);
    retranslates(this, [this] { retranslate(); });
}

void SettingForm::addHeading(Text text)
{
    auto* heading = new QLabel(text());
    heading->setContentsMargins(0, m_headings.empty() ? 4 : 12, 0, 0);
    addHeadingRow(heading);
    m_fold = nullptr;
    m_headings.emplace_back(heading, std::move(text));
}

void SettingForm::addFold(const char* name, Text text)
{
    auto* fold = new QToolButton;
    fold->setObjectName(QLatin1String(name));
    fold->setAutoRaise(true);
    fold->setCheckable(true);
    fold->setArrowType(Qt::RightArrow);
    fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    fold->setFocusPolicy(Qt::TabFocus);
    addHeadingRow(fold);
    m_fold = fold;
    m_folds.emplace_back(fold, std::move(text));
    connect(fold, &QToolButton::toggled, this, [this, fold](bool isOpen) {
        fold->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
        for (const Row& row : m_rows)
            showRow(row);
    });
}

void SettingForm::addHeadingRow(QWidget* heading)
{
    QFont font = heading->font();
    font.setWeight(QFont::DemiBold);
    heading->setFont(font);
    m_grid->addWidget(heading, m_grid->rowCount(), 0, 1, ColumnCount, Qt::AlignLeft);
}

void SettingForm::add(const char* name, Text label, Text tip, QWidget* field, std::function<void()> reset)
{
    const int place = m_grid->rowCount();
    Row row{.label = nullptr,
            .field = field,
            .reset = new QToolButton,
            .problem = new QLabel,
            .text = std::move(label),
            .tip = std::move(tip),
            .fold = m_fold};
    field->setObjectName(QLatin1String(name));
    field->setMinimumHeight(rowHeight);
    if (row.text) {
        row.label = new QLabel;
        row.label->setBuddy(field);
        // Long words give way before the buttons at the end do.
        row.label->setWordWrap(true);
        m_grid->addWidget(row.label, place, LabelColumn);
        m_grid->addWidget(field, place, FieldColumn);
    } else {
        m_grid->addWidget(field, place, LabelColumn, 1, 2);
    }
    row.reset->setObjectName(QLatin1String(name) + QStringLiteral("Reset"));
    row.reset->setIcon(widgets::icons::icon(QStringLiteral("undo")));
    row.reset->setAutoRaise(true);
    row.reset->setFocusPolicy(Qt::TabFocus);
    QSizePolicy keepsItsPlace = row.reset->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    row.reset->setSizePolicy(keepsItsPlace);
    m_grid->addWidget(row.reset, place, ResetColumn, Qt::AlignTop);
    connect(row.reset, &QToolButton::clicked, this, [reset = std::move(reset)] { reset(); });
    row.problem->setObjectName(QLatin1String(name) + QStringLiteral("Problem"));
    row.problem->setWordWrap(true);
    row.problem->setForegroundRole(QPalette::PlaceholderText);
    m_grid->addWidget(row.problem, place + 1, LabelColumn, 1, ColumnCount);
    showRow(row);
    m_rows.push_back(std::move(row));
    retranslate();
}

SettingForm::Row& SettingForm::rowOf(const QWidget* field)
{
    const auto found = std::ranges::find(m_rows, field, &Row::field);
    assert(found != m_rows.end());
    return *found;
}

void SettingForm::setUsual(const QWidget* field, bool usual)
{
    Row& row = rowOf(field);
    // A button that goes takes the keyboard along: the field keeps it.
    if (usual && row.reset->hasFocus())
        row.field->setFocus();
    row.isUsual = usual;
    showRow(row);
}

void SettingForm::setProblem(const QWidget* field, const QString& sentence)
{
    Row& row = rowOf(field);
    row.problem->setText(sentence);
    showRow(row);
}

void SettingForm::setRowVisible(const QWidget* field, bool visible)
{
    Row& row = rowOf(field);
    row.isVisible = visible;
    showRow(row);
}

void SettingForm::showRow(const Row& row)
{
    const bool visible = row.isVisible && (row.fold == nullptr || row.fold->isChecked());
    if (row.label != nullptr)
        row.label->setVisible(visible);
    row.field->setVisible(visible);
    row.problem->setVisible(visible && !row.problem->text().isEmpty());
    row.reset->setVisible(visible && !row.isUsual);
    // Its place is kept for the button in rows that are seen, not in others.
    QSizePolicy policy = row.reset->sizePolicy();
    policy.setRetainSizeWhenHidden(visible);
    row.reset->setSizePolicy(policy);
}

void SettingForm::retranslate()
{
    for (const auto& [label, text] : m_headings)
        label->setText(text());
    for (const auto& [fold, text] : m_folds)
        fold->setText(text());
    for (const Row& row : m_rows) {
        if (row.label != nullptr) {
            row.label->setText(row.text());
            row.label->setToolTip(row.tip());
            row.field->setAccessibleName(row.text());
        }
        row.field->setToolTip(row.tip());
        row.reset->setToolTip(tr("Back to the usual value"));
        row.reset->setAccessibleName(row.reset->toolTip());
    }
}

} // namespace quadrille

#include "moc_settingform.cpp"

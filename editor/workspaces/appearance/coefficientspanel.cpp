// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/coefficientspanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QSlider>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr int firstTextures = 5; ///< that are shown without asking
constexpr int firstWarps = 3;
constexpr double reach = 3; ///< of the sliders, standard deviations; numbers go farther
constexpr double farReach = 10;
constexpr int sliderSteps = 100; ///< for one standard deviation
constexpr int panelMargin = 12;

/// "T1" or "W1": of the first Eigen texture or Eigen warp.
QString shortName(const ShownTexture::Component& component)
{
    const int number = component.index + 1;
    return component.space == ShownTexture::Space::Textures
               ? CoefficientsPanel::tr("T%1", "an Eigen texture").arg(number)
               : CoefficientsPanel::tr("W%1", "an Eigen warp").arg(number);
}

} // namespace

CoefficientsPanel::CoefficientsPanel(ShownTexture& shown, QWidget* parent)
    : QWidget(parent)
    , m_shown(shown)
    , m_frame(new QLabel)
    , m_empty(new QLabel)
    , m_content(new QWidget)
    , m_grid(new QGridLayout)
    , m_reset(new QPushButton)
    , m_mean(new QPushButton)
    , m_more(new QPushButton)
{
    setObjectName(QStringLiteral("coefficientsPanel"));
    arrangeWidgets();
    connect(m_reset, &QPushButton::clicked, &shown, &ShownTexture::reset);
    connect(m_mean, &QPushButton::clicked, &shown, &ShownTexture::toMean);
    connect(m_more, &QPushButton::clicked, this, [this] {
        m_showsAll = !m_showsAll;
        refresh();
    });
    connect(&shown, &ShownTexture::changed, this, &CoefficientsPanel::refresh);
    retranslates(this, [this] { retranslate(); });
}

void CoefficientsPanel::arrangeWidgets()
{
    m_frame->setObjectName(QStringLiteral("coefficientsFrame"));
    m_empty->setObjectName(QStringLiteral("coefficientsEmpty"));
    m_reset->setObjectName(QStringLiteral("coefficientsReset"));
    m_mean->setObjectName(QStringLiteral("coefficientsMean"));
    m_more->setObjectName(QStringLiteral("coefficientsMore"));
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_frame->setWordWrap(true);
    m_grid->setColumnStretch(1, 1);
    m_grid->setVerticalSpacing(2);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_reset);
    buttons->addWidget(m_mean);
    buttons->addStretch(1);
    auto* inside = new QVBoxLayout(m_content);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->addLayout(buttons);
    inside->addLayout(m_grid);
    inside->addWidget(m_more, 0, Qt::AlignLeft);
    auto* page = new QWidget;
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(panelMargin, panelMargin / 2, panelMargin, panelMargin);
    rows->addWidget(m_frame);
    rows->addWidget(m_empty);
    rows->addWidget(m_content);
    rows->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(verticalScroll(page));
}

void CoefficientsPanel::retranslate()
{
    m_reset->setText(tr("Frame’s own"));
    m_reset->setToolTip(tr("Take back what was changed by hand"));
    m_mean->setText(tr("Mean"));
    m_mean->setToolTip(tr("Put all coefficients to zero, which is the mean texture"));
    m_rows.clear();
    refresh();
}

std::vector<ShownTexture::Component> CoefficientsPanel::wantedRows() const
{
    std::vector<ShownTexture::Component> wanted;
    const auto add = [&](ShownTexture::Space space, int first) {
        const int used = m_shown.usedOf(space);
        for (int index = 0; index < (m_showsAll ? used : std::min(first, used)); ++index)
            wanted.push_back({space, index});
    };
    add(ShownTexture::Space::Textures, firstTextures);
    add(ShownTexture::Space::Warps, firstWarps);
    return wanted;
}

void CoefficientsPanel::refresh()
{
    const bool hasModel = m_shown.componentCount() > 0;
    const bool isKnown = m_shown.coefficients().has_value();
    m_content->setVisible(hasModel);
    m_empty->setVisible(!hasModel || !isKnown);
    m_empty->setText(hasModel
                         ? tr("The model has not learned this frame. Moving a slider begins at the mean.")
                         : tr("Coefficients of the frame that is shown stand here, once the model is "
                              "built."));
    const auto frame = m_shown.appearance().frame();
    m_frame->setVisible(hasModel && frame.has_value());
    if (frame)
        m_frame->setText(m_shown.isEdited() ? tr("%1, changed by hand").arg(frameText(*frame))
                                            : frameText(*frame));
    m_reset->setEnabled(m_shown.isEdited());
    const int usable =
        m_shown.usedOf(ShownTexture::Space::Textures) + m_shown.usedOf(ShownTexture::Space::Warps);
    const int first = std::min(firstTextures, m_shown.usedOf(ShownTexture::Space::Textures)) +
                      std::min(firstWarps, m_shown.usedOf(ShownTexture::Space::Warps));
    m_more->setVisible(usable > first);
    m_more->setText(m_showsAll ? tr("Show fewer") : tr("Show all %1").arg(usable));
    makeRows();
    showValues();
}

/// As many as there are components; those that can stay do, so that a slider keeps the pointer.
void CoefficientsPanel::makeRows()
{
    const auto wanted = wantedRows();
    std::vector<ShownTexture::Component> present;
    for (const Row& row : m_rows)
        present.push_back(row.component);
    if (present == wanted)
        return;
    while (QLayoutItem* item = m_grid->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_rows.clear();
    for (const ShownTexture::Component& component : wanted)
        addRow(component);
}

void CoefficientsPanel::addRow(const ShownTexture::Component& component)
{
    const QString name = shortName(component);
    const QString kind =
        component.space == ShownTexture::Space::Textures ? QStringLiteral("Texture") : QStringLiteral("Warp");
    Row row{component, new QLabel(name), new QSlider(Qt::Horizontal), new QDoubleSpinBox};
    row.slider->setObjectName(QStringLiteral("coefficient%1%2").arg(kind).arg(component.index + 1));
    row.number->setObjectName(row.slider->objectName() + QStringLiteral("Number"));
    row.slider->setRange(static_cast<int>(-reach * sliderSteps), static_cast<int>(reach * sliderSteps));
    row.slider->setPageStep(sliderSteps / 2);
    row.slider->setSingleStep(sliderSteps / 10);
    row.number->setRange(-farReach, farReach);
    row.number->setSingleStep(0.1);
    row.number->setDecimals(2);
    row.number->setSuffix(tr(" σ", "standard deviations"));
    row.number->setKeyboardTracking(false);
    row.number->setAlignment(Qt::AlignRight);
    const QString tip =
        component.space == ShownTexture::Space::Textures
            ? tr("Eigen texture %1, in standard deviations from the mean").arg(component.index + 1)
            : tr("Eigen warp %1, in standard deviations from the mean").arg(component.index + 1);
    row.label->setToolTip(tip);
    row.label->setBuddy(row.number);
    for (QWidget* field : std::initializer_list<QWidget*>{row.slider, row.number}) {
        field->setToolTip(tip);
        field->setAccessibleName(name);
    }
    const auto set = [this, component](double deviations) {
        if (!m_isShowing)
            m_shown.setDeviations(component, deviations);
    };
    connect(row.slider, &QSlider::valueChanged, this,
            [set](int value) { set(static_cast<double>(value) / sliderSteps); });
    connect(row.number, &QDoubleSpinBox::valueChanged, this, set);
    const int line = m_grid->rowCount();
    m_grid->addWidget(row.label, line, 0);
    m_grid->addWidget(row.slider, line, 1);
    m_grid->addWidget(row.number, line, 2);
    m_rows.push_back(row);
}

void CoefficientsPanel::showValues()
{
    const QScopedValueRollback showing(m_isShowing, true);
    for (const Row& row : m_rows) {
        const double deviations = m_shown.deviations(row.component);
        row.slider->setValue(static_cast<int>(std::lround(deviations * sliderSteps)));
        row.number->setValue(deviations);
    }
}

} // namespace quadrille

#include "moc_coefficientspanel.cpp"

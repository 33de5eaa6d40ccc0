// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/theme/theme.h"

#include "widgets/theme/outlinestyle.h"
#include "widgets/theme/systemscheme.h"

#include <QApplication>
#include <QFile>
#include <QFontMetricsF>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStyle>
#include <algorithm>
#include <cmath>

// Resources of a static library have to be asked for, outside of any namespace.
static void initWidgetResources()
{
    Q_INIT_RESOURCE(widgets);
}

namespace quadrille::widgets {

namespace {

constexpr std::array<const char*, static_cast<std::size_t>(ColorRole::Count)> roleNames = {
    "window",      "base",        "raised",         "hover",        "pressed",    "divider",     "line",
    "text",        "textMuted",   "textDisabled",   "accent",       "accentText", "onAccent",    "selection",
    "onSelection", "viewportTop", "viewportBottom", "viewportText", "grid",       "axisX",       "axisY",
    "axisZ",       "clay",        "wire",           "original",     "synthetic",  "key",         "demanded",
    "error",       "errorText",   "warning",        "warningText",  "success",    "successText", "onMark"};

double luminance(const QColor& color)
{
    const auto linear = [](double channel) {
        return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

} // namespace

ThemeColors ThemeColors::fromFile(const QString& path)
{
    QFile file(path);
    const bool opened = file.open(QIODevice::ReadOnly);
    Q_ASSERT(opened);
    Q_UNUSED(opened)
    const QJsonObject table = QJsonDocument::fromJson(file.readAll()).object();
    ThemeColors colors;
    for (std::size_t i = 0; i < roleNames.size(); ++i) {
        colors.m_colors[i] = QColor(table.value(QLatin1String(roleNames[i])).toString());
        Q_ASSERT(colors.m_colors[i].isValid());
    }
    return colors;
}

QString ThemeColors::name(ColorRole role)
{
    return QString::fromLatin1(roleNames[static_cast<std::size_t>(role)]);
}

Theme::Theme()
{
    initWidgetResources();
    m_startedDark = luminance(QApplication::palette().color(QPalette::Window)) < 0.2;
    m_dark = systemIsDark();
    m_colors = ThemeColors::fromFile(m_dark ? QStringLiteral(":/themes/dark.json")
                                            : QStringLiteral(":/themes/light.json"));
}

Theme& Theme::instance()
{
    static Theme theme;
    return theme;
}

QColor Theme::categorical(int index)
{
    // Okabe and Ito's eight without black, then Tableau 10 without the near repeats.
    static constexpr std::array<QRgb, 15> colors = {0xE69F00, 0x56B4E9, 0x009E73, 0xF0E442, 0x0072B2,
                                                    0xD55E00, 0xCC79A7, 0x4E79A7, 0xF28E2B, 0xE15759,
                                                    0x76B7B2, 0x59A14F, 0xEDC948, 0xB07AA1, 0x9C755F};
    return QColor::fromRgb(colors[static_cast<std::size_t>(std::max(index, 0)) % colors.size()]);
}

QFont Theme::tabularFont(const QFont& base)
{
    // Qt 6.4 cannot ask a font for its "tnum" feature: where digits differ in width, take a font where not.
    QFont font = base;
    const QFontMetricsF metrics(font);
    const double zero = metrics.horizontalAdvance(u'0');
    const bool equal = std::all_of(std::begin(u"123456789"), std::end(u"123456789") - 1, [&](char16_t digit) {
        return std::abs(metrics.horizontalAdvance(QChar(digit)) - zero) < 0.01;
    });
    if (!equal)
        font.setFamilies({QStringLiteral("DejaVu Sans"), QStringLiteral("Noto Sans"), base.family()});
    return font;
}

QColor Theme::textOn(const QColor& background)
{
    const QColor dark(0x10, 0x11, 0x14);
    return contrast(dark, background) >= contrast(Qt::white, background) ? dark : QColor(Qt::white);
}

double Theme::contrast(const QColor& a, const QColor& b)
{
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

int Theme::animationMilliseconds()
{
    if (qEnvironmentVariableIsSet("QUADRILLE_NO_ANIMATION"))
        return 0;
    return QApplication::style()->styleHint(QStyle::SH_Widget_Animation_Duration) > 0 ? 140 : 0;
}

void Theme::install()
{
    QApplication::setStyle(new OutlineStyle);
    m_installed = true;
    watchSystem();
    setMode(m_mode);
}

void Theme::setMode(Mode mode)
{
    m_mode = mode;
    m_dark = mode == Mode::System ? systemIsDark() : mode == Mode::Dark;
    m_colors = ThemeColors::fromFile(m_dark ? QStringLiteral(":/themes/dark.json")
                                            : QStringLiteral(":/themes/light.json"));
    apply();
}

bool Theme::systemIsDark() const
{
    return systemPrefersDark().value_or(m_startedDark);
}

void Theme::watchSystem()
{
    connectToSystemScheme(this, SLOT(onPortalSetting(QString, QString)));
}

void Theme::onPortalSetting(const QString& group, const QString& key)
{
    if (m_mode == Mode::System && group == QLatin1String("org.freedesktop.appearance") &&
        key == QLatin1String("color-scheme") && systemIsDark() != m_dark)
        setMode(Mode::System);
}

void Theme::apply()
{
    if (m_installed) {
        QApplication::setPalette(palette());
        qApp->setStyleSheet(styleSheet());
    }
    emit changed();
}

QPalette Theme::palette() const
{
    const auto c = [this](ColorRole role) { return m_colors[role]; };
    QPalette p;
    p.setColor(QPalette::Window, c(ColorRole::Window));
    p.setColor(QPalette::WindowText, c(ColorRole::Text));
    p.setColor(QPalette::Base, c(ColorRole::Base));
    p.setColor(QPalette::AlternateBase, c(ColorRole::Window));
    p.setColor(QPalette::Text, c(ColorRole::Text));
    p.setColor(QPalette::PlaceholderText, c(ColorRole::TextMuted));
    p.setColor(QPalette::Button, c(ColorRole::Raised));
    p.setColor(QPalette::ButtonText, c(ColorRole::Text));
    p.setColor(QPalette::BrightText, c(ColorRole::ErrorText));
    p.setColor(QPalette::ToolTipBase, c(ColorRole::Raised));
    p.setColor(QPalette::ToolTipText, c(ColorRole::Text));
    p.setColor(QPalette::Highlight, c(ColorRole::Selection));
    p.setColor(QPalette::HighlightedText, c(ColorRole::OnSelection));
    p.setColor(QPalette::Link, c(ColorRole::AccentText));
    p.setColor(QPalette::LinkVisited, c(ColorRole::AccentText));
    p.setColor(QPalette::Light, c(ColorRole::Hover));
    p.setColor(QPalette::Midlight, c(ColorRole::Hover));
    p.setColor(QPalette::Mid, c(ColorRole::Divider));
    p.setColor(QPalette::Dark, c(ColorRole::Divider));
    p.setColor(QPalette::Shadow, c(ColorRole::Base).darker(130));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                                           QPalette::HighlightedText, QPalette::PlaceholderText})
        p.setColor(QPalette::Disabled, role, c(ColorRole::TextDisabled));
    p.setColor(QPalette::Disabled, QPalette::Highlight, c(ColorRole::Divider));
    return p;
}

QString Theme::styleSheet() const
{
    QFile file(QStringLiteral(":/themes/style.qss"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString sheet = QString::fromUtf8(file.readAll());
    // Longest names first, so that @textMuted is not taken for @text.
    std::vector<ColorRole> roles(static_cast<std::size_t>(ColorRole::Count));
    for (std::size_t i = 0; i < roles.size(); ++i)
        roles[i] = static_cast<ColorRole>(i);
    std::sort(roles.begin(), roles.end(), [](ColorRole a, ColorRole b) {
        return ThemeColors::name(a).size() > ThemeColors::name(b).size();
    });
    for (const ColorRole role : roles)
        sheet.replace(QLatin1Char('@') + ThemeColors::name(role), m_colors[role].name());
    return sheet;
}

StyleWhenComplete::StyleWhenComplete() : m_sheet(qApp->styleSheet())
{
    if (!m_sheet.isEmpty())
        qApp->setStyleSheet({});
}

StyleWhenComplete::~StyleWhenComplete()
{
    if (!m_sheet.isEmpty())
        qApp->setStyleSheet(m_sheet);
}

} // namespace quadrille::widgets

#include "moc_theme.cpp"

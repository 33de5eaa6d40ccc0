// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/theme/icons.h"

#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace quadrille::widgets {

namespace {

QString iconPath(const QString& name)
{
    return QStringLiteral(":/icons/%1.svg").arg(name);
}

/// The picture's text with its colour, and with strokes that come out 1.5 pixels wide at a size.
QByteArray recoloured(const QString& name, const QColor& color, double size)
{
    QFile file(iconPath(name));
    const bool opened = file.open(QIODevice::ReadOnly);
    Q_ASSERT_X(opened, "icons", qPrintable(name));
    Q_UNUSED(opened)
    constexpr double gridSize = 24.0;
    constexpr double strokePixels = 1.5;
    QByteArray svg = file.readAll();
    svg.replace("currentColor", color.name().toLatin1());
    svg.replace("stroke-width=\"1.5\"",
                "stroke-width=\"" + QByteArray::number(strokePixels * gridSize / size, 'f', 3) + '"');
    return svg;
}

class ThemeIconEngine : public QIconEngine
{
public:
    ThemeIconEngine(QString name, ColorRole role) : m_name(std::move(name)), m_role(role) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override
    {
        const double ratio = painter->device()->devicePixelRatioF();
        const int side = std::min(rect.width(), rect.height());
        const QRect square(rect.center() - QPoint(side / 2, side / 2) + QPoint(1 - side % 2, 1 - side % 2),
                           QSize(side, side));
        painter->drawPixmap(square, icons::pixmap(m_name, side, color(mode, state), ratio));
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        return scaledPixmap(size, mode, state, 1.0);
    }

    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal scale) override
    {
        // Qt 6.4 gives the size in device pixels here, and sets the ratio on what it gets.
        const int logical = qRound(std::min(size.width(), size.height()) / scale);
        return icons::pixmap(m_name, std::max(logical, 1), color(mode, state), scale);
    }

    QIconEngine* clone() const override { return new ThemeIconEngine(*this); }
    QString key() const override { return QStringLiteral("quadrille"); }
    QString iconName() override { return m_name; }

private:
    QColor color(QIcon::Mode mode, QIcon::State state) const
    {
        if (mode == QIcon::Disabled)
            return Theme::color(ColorRole::TextDisabled);
        if (mode == QIcon::Selected)
            return Theme::color(ColorRole::OnSelection);
        return Theme::color(state == QIcon::On && m_role == ColorRole::Text ? ColorRole::AccentText : m_role);
    }

    QString m_name;
    ColorRole m_role;
};

} // namespace

namespace icons {

QIcon icon(const QString& name, ColorRole role)
{
    Q_ASSERT_X(QFile::exists(iconPath(name)), "icons", qPrintable(name));
    return QIcon(new ThemeIconEngine(name, role));
}

QPixmap pixmap(const QString& name, int size, const QColor& color, double devicePixelRatio)
{
    const QString key =
        QStringLiteral("quadrille:%1:%2:%3:%4")
            .arg(name, color.name(), QString::number(size), QString::number(devicePixelRatio));
    QPixmap result;
    if (QPixmapCache::find(key, &result))
        return result;
    result = QPixmap(QSize(size, size) * devicePixelRatio);
    result.fill(Qt::transparent);
    QPainter painter(&result);
    QSvgRenderer(recoloured(name, color, size)).render(&painter, QRectF(result.rect()));
    painter.end();
    result.setDevicePixelRatio(devicePixelRatio);
    QPixmapCache::insert(key, result);
    return result;
}

QStringList names()
{
    Theme::instance(); // registers the resources
    QStringList all = QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")});
    all.replaceInStrings(QStringLiteral(".svg"), QString());
    return all;
}

QIcon application()
{
    Theme::instance();
    QIcon icon;
    for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
        QPixmap picture(size, size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        QSvgRenderer(QStringLiteral(":/appicon/quadrille.svg")).render(&painter);
        painter.end();
        icon.addPixmap(picture);
    }
    return icon;
}

} // namespace icons

} // namespace quadrille::widgets

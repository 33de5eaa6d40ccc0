// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/help/helpbrowser.h"

#include <QImage>
#include <QScrollBar>

namespace quadrille {

QVariant HelpBrowser::loadResource(int type, const QUrl& name)
{
    QVariant resource = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource)
        return resource;
    QImage picture = resource.canConvert<QImage>() ? resource.value<QImage>() : QImage();
    if (picture.isNull())
        picture.loadFromData(resource.toByteArray());
    m_pictureWidth = textWidth();
    const auto pixels = static_cast<int>(m_pictureWidth * devicePixelRatioF());
    if (picture.width() > pixels)
        picture = picture.scaledToWidth(pixels, Qt::SmoothTransformation);
    picture.setDevicePixelRatio(devicePixelRatioF());
    return picture;
}

void HelpBrowser::resizeEvent(QResizeEvent* event)
{
    QTextBrowser::resizeEvent(event);
    if (m_pictureWidth == 0 || m_pictureWidth == textWidth())
        return;
    m_pictureWidth = 0;
    // Not at once: a scroll bar that comes while a page is read resizes it in the middle of that.
    const auto again = [this] {
        const int place = verticalScrollBar()->value();
        reload();
        verticalScrollBar()->setValue(place);
    };
    QMetaObject::invokeMethod(this, again, Qt::QueuedConnection);
}

int HelpBrowser::textWidth() const
{
    return viewport()->width() - static_cast<int>(2 * document()->documentMargin());
}

} // namespace quadrille

#include "moc_helpbrowser.cpp"

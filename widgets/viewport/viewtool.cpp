// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/viewtool.h"

namespace quadrille::widgets {

void ViewTool::setView(const Turntable& camera, const QSizeF& size)
{
    if (camera == m_camera && size == m_size)
        return;
    m_camera = camera;
    m_size = size;
    viewChanged();
    emit repaintRequested();
}

} // namespace quadrille::widgets

#include "moc_viewtool.cpp"

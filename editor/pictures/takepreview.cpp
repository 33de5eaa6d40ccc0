// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/pictures/takepreview.h"

#include "editor/errors/errortext.h"
#include "editor/jobs/jobrunner.h"
#include "editor/pictures/pictures.h"
#include "model/render/thumbnail.h"
#include "widgets/theme/theme.h"

#include <algorithm>

namespace quadrille {

TakePreview::TakePreview(JobRunner& jobs, QWidget* parent) : QLabel(parent), m_jobs(jobs)
{
    setObjectName(QStringLiteral("takePreview"));
    setFixedSize(side, side);
    setAlignment(Qt::AlignCenter);
    setWordWrap(true);
}

void TakePreview::draw(const MeshSequence* sequence, const CoordinateSystem& axes)
{
    if (sequence == nullptr) {
        ++m_generation;
        clear();
        return;
    }
    const auto background = widgets::Theme::instance().isDark() ? RenderOptions::Background::Dark
                                                                : RenderOptions::Background::Light;
    draw(*sequence, thumbnailLook(side, side, background, axes));
}

void TakePreview::draw(const MeshSequence& sequence, RenderOptions look)
{
    ++m_generation;
    const double scale = side * devicePixelRatioF() / std::max(look.width, look.height);
    look.width = std::max(1, static_cast<int>(look.width * scale));
    look.height = std::max(1, static_cast<int>(look.height * scale));
    m_jobs.start(
        {.name = tr("Drawing the preview"),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         .failed = [this](const Error& error) { setText(describe(error).sentence); },
         .background = true},
        [take = sequence, look](const Progress&) { return thumbnail(take, look); },
        [this](Image picture) {
            QPixmap pixmap = QPixmap::fromImage(toQImage(std::move(picture)));
            pixmap.setDevicePixelRatio(devicePixelRatioF());
            setPixmap(pixmap);
        });
}

} // namespace quadrille

#include "moc_takepreview.cpp"

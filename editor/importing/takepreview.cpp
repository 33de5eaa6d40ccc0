// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/importing/takepreview.h"

#include "editor/documents/pictures.h"
#include "editor/errors/errortext.h"
#include "editor/jobs/jobrunner.h"
#include "model/render/thumbnail.h"
#include "widgets/theme/theme.h"

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
    ++m_generation;
    clear();
    if (sequence == nullptr)
        return;
    const auto pixels = static_cast<int>(side * devicePixelRatioF());
    const RenderOptions look =
        thumbnailLook(pixels, pixels,
                      widgets::Theme::instance().isDark() ? RenderOptions::Background::Dark
                                                          : RenderOptions::Background::Light,
                      axes);
    m_jobs.start(
        {.name = tr("Drawing the preview"),
         .receiver = this,
         .stillStands = [this, generation = m_generation] { return generation == m_generation; },
         .failed = [this](const Error& error) { setText(describe(error).sentence); },
         .background = true},
        [take = *sequence, look](const Progress&) { return thumbnail(take, look); },
        [this](Image picture) {
            QPixmap pixmap = QPixmap::fromImage(toQImage(std::move(picture)));
            pixmap.setDevicePixelRatio(devicePixelRatioF());
            setPixmap(pixmap);
        });
}

} // namespace quadrille

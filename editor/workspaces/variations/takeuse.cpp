// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/takeuse.h"

#include <QCoreApplication>
#include <QLocale>

namespace quadrille {

namespace {

struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::TakeUse)
};

} // namespace

QString useText(TakeUse use)
{
    switch (use) {
    case TakeUse::Given:
        return Texts::tr("The frames that you chose");
    case TakeUse::Cycle:
        return Texts::tr("One cycle of the movement");
    case TakeUse::Whole:
        return Texts::tr("All frames");
    case TakeUse::TooShort:
        return Texts::tr("All frames: the take is shorter than a cycle");
    case TakeUse::NoCycle:
        return Texts::tr("All frames: the take has no cycle like the reference’s");
    }
    return {};
}

QString usedText(const FrameRange& frames)
{
    const QLocale locale;
    return QStringLiteral("%1–%2").arg(locale.toString(static_cast<qlonglong>(frames.first.value)),
                                       locale.toString(static_cast<qlonglong>(frames.last.value)));
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What a motion space is like once it is computed.
#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/fields/measuretext.h"
#include "editor/fields/partlist.h"
#include "editor/fields/spacemap.h"
#include "editor/properties/motionspacepage.h"
#include "model/project/document/findentry.h"

#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <algorithm>

namespace quadrille {

namespace {

/// The result of a space, or the one before while it is computed: what changes does so once. Null where there
/// is none.
const MotionSpaceResult* shownResult(const EditorContext& context, const QString& name)
{
    const MotionSpaceResults::State* state = context.motionSpaces.resultState(name);
    const bool isShown =
        state != nullptr && (state->phase == ResultPhase::Ready || state->phase == ResultPhase::Computing);
    return isShown ? state->result.get() : nullptr;
}

QString sizeText(const MotionSpace& space)
{
    std::size_t bytes = 0;
    for (const SpaceReference& reference : space.references)
        bytes += reference.memory();
    return QLocale().formattedDataSize(static_cast<qint64>(bytes));
}

double greatestError(const MotionSpaceResult& result)
{
    return std::ranges::max(columnNamed<std::vector<double>>(result.error, "greatest"));
}

} // namespace

void MotionSpacePage::showLists()
{
    QStringList takes;
    for (std::size_t t = 0; t < entry().takes.size(); ++t)
        takes += takeText(t);
    m_takes->fill(takes);
    QStringList parameters;
    for (std::size_t p = 0; p < entry().parameters.size(); ++p)
        parameters += parameterText(p);
    m_parameters->fill(parameters);
    m_addParameter->setEnabled(entry().parameters.size() < MotionSpaceEntry::mostParameters);
}

QString MotionSpacePage::takeText(std::size_t index) const
{
    const SpaceTakeEntry& shown = entry().takes[index];
    QStringList parts{QString::fromStdString(shown.sequence)};
    if (shown.isMirrored)
        parts += tr("mirrored");
    if (shown.isReversed)
        parts += tr("reversed");
    if (shown.speed != 1)
        parts += QStringLiteral("× ") + QLocale().toString(shown.speed, 'g', 4);
    const MotionSpaceResult* result = shownResult(context(), entryName());
    if (result != nullptr && index < result->entry.takes.size() && result->entry.takes[index] == shown) {
        const SpacePoint& place = result->space->weights.nodes()[index].place;
        for (std::size_t p = 0; p < result->space->parameters.size(); ++p)
            parts += measureText(place[p], result->space->parameters[p].measure);
    }
    return parts.join(QStringLiteral(" · "));
}

QString MotionSpacePage::parameterText(std::size_t index) const
{
    const SpaceParameterEntry& shown = entry().parameters[index];
    QString name = QString::fromStdString(shown.name);
    const MotionSpaceResult* result = shownResult(context(), entryName());
    if (result == nullptr || index >= result->entry.parameters.size() ||
        result->entry.parameters[index].measure != shown.measure)
        return name;
    const ParameterMap& map = result->space->map;
    const SpaceMeasure measure = result->space->parameters[index].measure;
    return tr("%1 · %2 to %3, missed by %4 at most")
        .arg(name, measureText(map.least[index], measure), measureText(map.greatest[index], measure),
             measureText(map.worstResidual[index], measure));
}

void MotionSpacePage::showState()
{
    const MotionSpaceResults::State* state = context().motionSpaces.resultState(entryName());
    const MotionSpaceResult* result = shownResult(context(), entryName());
    m_map->setSpace(result == nullptr ? nullptr : result->space);
    m_map->setVisible(result != nullptr);
    m_map->setEnabled(state != nullptr && state->phase == ResultPhase::Ready);
    if (state == nullptr || state->phase == ResultPhase::Impossible) {
        m_state->setText(entry().takes.empty() ? tr("It has no takes") : QString());
    } else if (state->phase == ResultPhase::Failed) {
        m_state->setText(describe(*state->error).oneLine());
    } else if (state->phase != ResultPhase::Ready) {
        m_state->setText(tr("Being computed …"));
    } else {
        const MotionSpace& space = *state->result->space;
        const QString frames = tr("%n frame(s)", nullptr, static_cast<int>(space.frameCount()));
        m_state->setText(tr("%1, %2; %3, %4; blends miss non-linear ones by %5 mm at most")
                             .arg(frames, space.isCyclic ? tr("repeats") : tr("plays once"),
                                  tr("%n reference(s)", nullptr, static_cast<int>(space.references.size())),
                                  sizeText(space),
                                  QLocale().toString(1000 * greatestError(*state->result), 'f', 1)));
    }
}

} // namespace quadrille

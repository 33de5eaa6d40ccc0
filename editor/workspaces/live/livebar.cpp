// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/live/livebar.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/namebox.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/live/livepaths.h"
#include "editor/workspaces/live/livesession.h"
#include "widgets/controls/elidedlabel.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLocale>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr int liveBarGap = 8;          // pixels
constexpr int liveProgressWidth = 110; // pixels
constexpr int liveFullProgress = 1000;

} // namespace

LiveBar::LiveBar(EditorContext& context, LiveSession& session, LivePaths& paths, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_session(session)
    , m_paths(paths)
    , m_names(new QComboBox)
    , m_path(new QComboBox)
    , m_progress(new QProgressBar)
    , m_state(new widgets::ElidedLabel)
{
    setObjectName(QStringLiteral("liveBar"));
    m_names->setObjectName(QStringLiteral("liveNames"));
    m_progress->setObjectName(QStringLiteral("liveProgress"));
    m_progress->setRange(0, liveFullProgress);
    m_progress->setFixedWidth(liveProgressWidth);
    m_progress->setTextVisible(false);
    m_progress->hide();
    m_state->setObjectName(QStringLiteral("liveState"));
    m_state->setFont(widgets::Theme::tabularFont(m_state->font()));
    m_path->setObjectName(QStringLiteral("livePath"));
    fitToNames(*m_names);
    fitToNames(*m_path);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(liveBarGap, liveBarGap / 2, liveBarGap, liveBarGap / 2);
    row->setSpacing(liveBarGap / 2);
    const auto add = [&](std::initializer_list<const char*> ids) {
        for (const char* id : ids)
            row->addWidget(makeActionButton(context.actions.action(QLatin1String(id))));
        row->addSpacing(liveBarGap);
    };
    add({"live.run", "live.record", "live.restart"});
    row->addWidget(m_path);
    row->addSpacing(liveBarGap);
    row->addWidget(m_names);
    add({"live.addSequence", "live.export"});
    row->addWidget(m_progress);
    row->addWidget(m_state, 1);
    connect(m_names, &QComboBox::activated, this, [this] {
        m_context.selection.select({Section::Lives, m_names->currentText()});
    });
    connect(m_path, &QComboBox::activated, this,
            [this] { m_paths.choose(m_path->currentData().toString()); });
    connect(&paths, &LivePaths::changed, this, &LiveBar::refreshPaths);
    connect(&context.document, &ProjectDocument::changed, this, &LiveBar::refresh);
    connect(&context.selection, &Selection::changed, this, &LiveBar::refresh);
    connect(&session, &LiveSession::changed, this, [this] {
        refreshPaths();
        showState();
    });
    connect(&session, &LiveSession::ticked, this, &LiveBar::showState);
    retranslates(this, [this] { retranslate(); });
}

void LiveBar::showProgress(double share)
{
    m_progress->setVisible(share >= 0);
    m_progress->setValue(static_cast<int>(std::lround(share * liveFullProgress)));
    showState();
}

void LiveBar::retranslate()
{
    m_names->setAccessibleName(tr("Recorded performances"));
    m_names->setToolTip(tr("Recorded performances; choosing one plays it again"));
    m_names->setPlaceholderText(tr("No recording"));
    m_path->setAccessibleName(tr("Path to follow"));
    m_path->setToolTip(tr("The path of an animation, which is followed around its obstacles from its "
                          "beginning; whoever steers takes over"));
    refreshPaths();
    refresh();
}

void LiveBar::refresh()
{
    const QSignalBlocker blocker(m_names);
    m_names->clear();
    for (const LiveEntry& each : m_context.document.project().lives)
        m_names->addItem(QString::fromStdString(each.name));
    const EntryRef& current = m_context.selection.current();
    m_names->setCurrentIndex(current.section == Section::Lives ? m_names->findText(current.name) : -1);
    m_names->setEnabled(m_names->count() > 0);
    showState();
}

void LiveBar::refreshPaths()
{
    const QSignalBlocker blocker(m_path);
    m_path->clear();
    m_path->addItem(tr("By hand"), QString());
    for (const QString& name : m_paths.names())
        m_path->addItem(tr("Along “%1”").arg(name), name);
    m_path->setCurrentIndex(std::max(0, m_path->findData(m_paths.chosen())));
    m_path->setEnabled(m_session.isReady() && m_path->count() > 1);
}

void LiveBar::showState()
{
    QString text;
    if (m_progress->isVisible()) {
        text = tr("Preparing motion spaces…");
    } else if (m_session.isReady()) {
        const auto seconds = [this](std::int64_t ticks) {
            return QLocale().toString(static_cast<double>(ticks) * m_session.tickSeconds(), 'f', 1);
        };
        const QString now = seconds(m_session.state().tick);
        if (m_session.isRecording())
            text = tr("Recording: %1 s").arg(seconds(m_session.recordedTicks()));
        else if (m_session.isReplaying())
            text = tr("Replay: %1 of %2 s").arg(now, seconds(m_session.tickCount()));
        else if (m_session.isRunning())
            text = tr("Live: %1 s").arg(now);
        else
            text = tr("Paused at %1 s").arg(now);
    }
    m_state->setText(text);
    m_state->setToolTip(text);
}

} // namespace quadrille

#include "moc_livebar.cpp"

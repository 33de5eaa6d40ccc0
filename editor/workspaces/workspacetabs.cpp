// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/workspacetabs.h"

#include "editor/context/editorcontext.h"
#include "editor/context/windowplace.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/view/viewactions.h"

#include <QDockWidget>
#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTabBar>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

/// From F5 to F10, then with Shift.
QKeySequence keyOf(int index)
{
    constexpr int plain = 6;
    const auto key = static_cast<Qt::Key>(Qt::Key_F5 + index % plain);
    return index < plain ? QKeySequence(key) : QKeySequence(Qt::SHIFT | key);
}

/// Of docks below the view, the first time: the view matters more.
constexpr int lowHeight = 150;
/// Of docks at the right that have others below them: parts of the window's width, but no less or more than
/// these pixels.
constexpr int wideShare = 5;
constexpr int leastWide = 385; // so that four tabs show
constexpr int mostWide = 400;
/// In which a window manager gives a window that is to fill the screen its size.
constexpr int settlingMilliseconds = 500;
/// In windows below this height such docks wait in the menu until somebody wants them.
constexpr int roomyHeight = 840;

} // namespace

WorkspaceTabs::WorkspaceTabs(EditorContext& context, QMainWindow& window)
    : m_context(context)
    , m_window(window)
    , m_strip(new QToolBar(&window))
    , m_bar(new QTabBar)
    , m_pages(new QStackedWidget)
    , m_viewActions(new ViewActions(context, this))
{
    setObjectName(QStringLiteral("workspaces"));
    m_bar->setObjectName(QStringLiteral("workspaceTabs"));
    m_bar->setDrawBase(false);
    m_bar->setExpanding(false);
    m_strip->setObjectName(QStringLiteral("workspaceStrip"));
    m_strip->setMovable(false);
    m_strip->toggleViewAction()->setVisible(false);
    m_strip->addWidget(m_bar);
    window.addToolBar(m_strip);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_pages);
    connect(m_bar, &QTabBar::currentChanged, this, &WorkspaceTabs::show);
    retranslates(this, [this] { retranslate(); });
}

void WorkspaceTabs::add(Entry entry)
{
    const QSignalBlocker blocker(m_bar);
    const auto index = static_cast<int>(m_entries.size());
    m_pages->addWidget(entry.workspace);
    m_bar->addTab(entry.title());
    m_context.actions.add({QStringLiteral("workspace.") + entry.id,
                           [] { return tr("Workspace"); },
                           entry.title,
                           {},
                           {},
                           {keyOf(index)}},
                          [this, index] { m_bar->setCurrentIndex(index); });
    m_entries.push_back(std::move(entry));
}

void WorkspaceTabs::begin()
{
    m_awaitsSize = m_window.isMaximized() || m_window.isFullScreen();
    m_window.installEventFilter(this);
    m_firstState = m_window.saveState();
    show(0);
}

/// A window that is to fill the screen is first laid out as large as it is otherwise, and its docks are
/// squeezed into that. The window manager gives it its size later, maybe in several steps.
bool WorkspaceTabs::eventFilter(QObject* watched, QEvent* event)
{
    if (m_awaitsSize && event->type() == QEvent::Resize && m_window.isVisible()) {
        QMetaObject::invokeMethod(
            this, [this] { arrange(); }, Qt::QueuedConnection);
        QTimer::singleShot(settlingMilliseconds, this, [this] { m_awaitsSize = false; });
    }
    return QWidget::eventFilter(watched, event);
}

void WorkspaceTabs::setShown(bool shown)
{
    m_strip->setVisible(shown);
    if (shown == m_isShown)
        return;
    if (shown) {
        m_isShown = true;
        for (QDockWidget* dock : std::exchange(m_hidden, {}))
            dock->show();
        arrange();
        return;
    }
    // A window that was never seen has not laid its docks out yet.
    if (m_window.isVisible())
        keepState();
    m_isShown = false;
    for (QDockWidget* dock : m_window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (dock->isHidden())
            continue;
        m_hidden += dock;
        dock->hide();
    }
}

/// The arrangement of the current workspace, to come back to. That of an empty window is none.
void WorkspaceTabs::keepState()
{
    if (m_isShown && m_current >= 0)
        m_states[current()] = m_window.saveState();
}

void WorkspaceTabs::select(const QString& id)
{
    const auto found = std::ranges::find(m_entries, id, &Entry::id);
    if (found != m_entries.end())
        m_bar->setCurrentIndex(static_cast<int>(found - m_entries.begin()));
}

QString WorkspaceTabs::current() const
{
    return m_current < 0 ? QString() : m_entries[static_cast<std::size_t>(m_current)].id;
}

Workspace* WorkspaceTabs::currentWorkspace() const
{
    return m_current < 0 ? nullptr : m_entries[static_cast<std::size_t>(m_current)].workspace;
}

void WorkspaceTabs::show(int index)
{
    if (index == m_current || index < 0)
        return;
    const bool hadFocus = hasFocusOf(m_current);
    keepState();
    if (m_current >= 0)
        currentWorkspace()->setActive(false);
    m_current = index;
    m_pages->setCurrentIndex(index);
    arrange();
    m_viewActions->setView(&currentWorkspace()->view());
    currentWorkspace()->setActive(true);
    if (hadFocus)
        currentWorkspace()->viewport().setFocus();
    emit currentChanged(current());
}

/// Whether the focus is in a workspace or its panels, and goes with them.
bool WorkspaceTabs::hasFocusOf(int index) const
{
    const QWidget* focus = m_window.focusWidget();
    if (focus == nullptr || index < 0)
        return false;
    const Entry& entry = m_entries[static_cast<std::size_t>(index)];
    return entry.workspace->isAncestorOf(focus) ||
           std::ranges::any_of(entry.docks,
                               [focus](const QDockWidget* dock) { return dock->isAncestorOf(focus); });
}

void WorkspaceTabs::arrange()
{
    const QSize size = m_window.size();
    arrangeDocks(m_current);
    // Docks that come one after another may ask for more height than they need once they share their places.
    const auto settle = [this, size] {
        const bool hasGrown =
            m_window.height() > size.height() && m_window.height() == m_window.minimumHeight();
        m_window.layout()->invalidate();
        m_window.layout()->activate();
        if (hasGrown && !m_window.isMaximized() && !m_window.isFullScreen())
            m_window.resize(size);
    };
    QMetaObject::invokeMethod(this, settle, Qt::QueuedConnection);
}

void WorkspaceTabs::arrangeDocks(int index)
{
    if (!m_isShown)
        return;
    const Entry& entry = m_entries[static_cast<std::size_t>(index)];
    const QByteArray state = m_states.value(entry.id);
    const bool stripIsShown = m_strip->isVisibleTo(&m_window);
    const bool isKnown = !state.isEmpty() && restoreDocks(m_window, state);
    m_strip->setVisible(stripIsShown);
    for (const Entry& each : m_entries) {
        for (QDockWidget* dock : each.docks) {
            const bool isOwn = each.id == entry.id;
            dock->toggleViewAction()->setVisible(isOwn);
            if (!isOwn)
                dock->hide();
        }
    }
    if (!isKnown)
        arrangeFirst(entry);
}

void WorkspaceTabs::arrangeFirst(const Entry& entry)
{
    m_properties->setVisible(!entry.hidesProperties);
    m_first->raise();
    const auto& docks = entry.docks;
    for (QDockWidget* dock : docks)
        dock->setVisible(dock->property("isShownFirst").toBool());
    if (docks.empty())
        return;
    docks.front()->raise();
    for (QDockWidget* dock : docks) {
        if (m_window.dockWidgetArea(dock) != Qt::BottomDockWidgetArea)
            continue;
        const bool isShown = dock->property("isShownFirst").toBool();
        dock->setVisible(isShown && m_window.height() >= roomyHeight);
        dock->setProperty(waitsForNeed, isShown && dock->isHidden());
        m_window.resizeDocks({dock}, {lowHeight}, Qt::Vertical);
    }
    const auto lower = std::ranges::find_if(
        docks, [](const QDockWidget* dock) { return dock->property("isLower").toBool(); });
    if (lower == docks.end())
        return;
    (*lower)->raise();
    m_window.resizeDocks({docks.front()}, {std::clamp(m_window.width() / wideShare, leastWide, mostWide)},
                         Qt::Horizontal);
    // Lists and charts above need their lines; what is below is a picture of any size.
    const QList<int> shares = m_window.height() < roomyHeight ? QList{2, 1} : QList{3, 2};
    m_window.resizeDocks({docks.front(), *lower}, shares, Qt::Vertical);
}

QByteArray WorkspaceTabs::arrangement() const
{
    return m_isShown ? m_window.saveState() : m_states.value(current());
}

void WorkspaceTabs::setArrangement(const QByteArray& state)
{
    m_states[current()] = state;
    arrange();
}

void WorkspaceTabs::resetArrangement()
{
    if (m_isShown)
        restoreDocks(m_window, m_firstState);
    setArrangement({});
}

QJsonObject WorkspaceTabs::states()
{
    keepState();
    QJsonObject json;
    for (auto it = m_states.cbegin(); it != m_states.cend(); ++it)
        json[it.key()] = QString::fromLatin1(it.value().toBase64());
    return json;
}

void WorkspaceTabs::setStates(const QJsonObject& states)
{
    for (auto it = states.begin(); it != states.end(); ++it)
        m_states[it.key()] = QByteArray::fromBase64(it.value().toString().toLatin1());
    if (m_current < 0)
        return;
    m_awaitsSize = m_window.isMaximized() || m_window.isFullScreen();
    QTimer::singleShot(settlingMilliseconds, this, [this] { m_awaitsSize = false; });
    arrange();
}

void WorkspaceTabs::retranslate()
{
    m_bar->setAccessibleName(tr("Workspaces"));
    m_strip->setWindowTitle(tr("Workspaces"));
    for (std::size_t i = 0; i < m_entries.size(); ++i)
        m_bar->setTabText(static_cast<int>(i), m_entries[i].title().remove(QLatin1Char('&')));
}

QJsonObject WorkspaceTabs::looks() const
{
    QJsonObject looks;
    for (const Entry& entry : m_entries) {
        if (const QJsonObject look = entry.workspace->look(); !look.isEmpty())
            looks[entry.id] = look;
    }
    return looks;
}

void WorkspaceTabs::setLooks(const QJsonObject& looks)
{
    for (const Entry& entry : m_entries) {
        if (looks.contains(entry.id))
            entry.workspace->setLook(looks[entry.id].toObject());
    }
}

} // namespace quadrille

#include "moc_workspacetabs.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/welcome/welcomepage.h"

#include "editor/application/session.h"
#include "editor/application/settings.h"
#include "editor/language/retranslate.h"
#include "widgets/theme/icons.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>

namespace quadrille {

WelcomePage::WelcomePage(Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_title(new QLabel)
    , m_lead(new QLabel)
    , m_sample(addButton("file.sample", "character"))
    , m_open(addButton("file.open", "open"))
    , m_import(addButton("file.import", "import"))
    , m_recentTitle(new QLabel)
    , m_recent(new QListWidget)
{
    setObjectName(QStringLiteral("welcomePage"));
    QFont heading = font();
    heading.setPointSizeF(heading.pointSizeF() * 2);
    heading.setWeight(QFont::DemiBold);
    m_title->setFont(heading);
    m_lead->setWordWrap(true);
    m_recent->setObjectName(QStringLiteral("recentProjects"));
    m_recent->setViewMode(QListView::IconMode);
    m_recent->setIconSize({160, 100});
    m_recent->setGridSize({172, 132});
    m_recent->setMovement(QListView::Static);
    m_recent->setResizeMode(QListView::Adjust);
    m_recent->setUniformItemSizes(true);
    m_recent->setFixedHeight(2 * 132 + 8);
    m_recent->viewport()->setAutoFillBackground(false);
    auto* forget = new QShortcut(QKeySequence::Delete, m_recent, nullptr, nullptr, Qt::WidgetShortcut);
    connect(forget, &QShortcut::activated, this, &WelcomePage::forgetCurrent);
    m_sample->setDefault(true);

    auto* content = new QWidget;
    content->setFixedWidth(3 * 172 + 24);
    auto* column = new QVBoxLayout(content);
    column->setSpacing(12);
    auto* logo = new QLabel;
    logo->setPixmap(widgets::icons::application().pixmap(64));
    for (QWidget* widget : std::initializer_list<QWidget*>{logo, m_title, m_lead, m_sample, m_open, m_import,
                                                           m_recentTitle, m_recent})
        column->addWidget(widget);
    auto* centre = new QGridLayout(this);
    centre->addWidget(content, 0, 0, Qt::AlignCenter);

    connect(m_recent, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { emit projectAsked(item->data(Qt::UserRole).toString()); });
    connect(&m_settings, &Settings::recentProjectsChanged, this, &WelcomePage::showRecent);
    showRecent();
    retranslates(this, [this] { retranslate(); });
}

QPushButton* WelcomePage::addButton(const char* action, const char* icon)
{
    auto* button = new QPushButton(widgets::icons::icon(QLatin1String(icon)), QString());
    button->setObjectName(QLatin1String(action));
    button->setMinimumHeight(32);
    connect(button, &QPushButton::clicked, this,
            [this, id = QString::fromLatin1(action)] { emit actionAsked(id); });
    return button;
}

void WelcomePage::showRecent()
{
    m_recent->clear();
    for (const QString& file : m_settings.recentProjects()) {
        const QFileInfo info(file);
        const QPixmap picture(thumbnailFile(file));
        auto* item = new QListWidgetItem(picture.isNull() ? widgets::icons::icon(QStringLiteral("project"))
                                                          : QIcon(picture),
                                         info.completeBaseName(), m_recent);
        item->setToolTip(info.exists() ? file : tr("%1 is not there any more. Del forgets it.").arg(file));
        item->setData(Qt::UserRole, file);
        if (!info.exists())
            item->setForeground(palette().brush(QPalette::Disabled, QPalette::Text));
    }
    const bool hasRecent = m_recent->count() > 0;
    m_recentTitle->setVisible(hasRecent);
    m_recent->setVisible(hasRecent);
}

void WelcomePage::forgetCurrent()
{
    if (const QListWidgetItem* item = m_recent->currentItem())
        m_settings.removeRecentProject(item->data(Qt::UserRole).toString());
}

void WelcomePage::showEvent(QShowEvent* event)
{
    showRecent(); // pictures may be new
    QWidget::showEvent(event);
}

void WelcomePage::retranslate()
{
    m_title->setText(QStringLiteral("Quadrille"));
    m_lead->setText(
        tr("Bring in captured performances: drop files or folders anywhere in this window, or begin here."));
    m_sample->setText(tr("Open the sample"));
    m_open->setText(tr("Open a project…"));
    m_import->setText(tr("Import sequences…"));
    m_recentTitle->setText(tr("Recent projects"));
    m_recent->setAccessibleName(tr("Recent projects"));
}

} // namespace quadrille

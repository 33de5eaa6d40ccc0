// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/projectstrips.h"

#include "editor/application/projectfiles.h"
#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"
#include "model/project/document/brokenentry.h"
#include "widgets/controls/messagestrip.h"

#include <QVBoxLayout>

namespace quadrille {

using widgets::MessageStrip;

ProjectStrips::ProjectStrips(EditorContext& context, ProjectFiles& files, QWidget* parent)
    : QWidget(parent), m_context(context), m_files(files), m_media(context.document)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_accessStrip = addStrip("accessStrip");
    m_changedStrip = addStrip("changedStrip");
    m_brokenStrip = addStrip("brokenStrip");
    m_mediaStrip = addStrip("mediaStrip");
    connect(m_accessStrip, &MessageStrip::actionTriggered, &files, &ProjectFiles::saveAs);
    connect(m_changedStrip, &MessageStrip::actionTriggered, &files, &ProjectFiles::reload);
    connect(m_brokenStrip, &MessageStrip::actionTriggered, this, [this] {
        m_context.selection.select({Section::Project, m_broken.front()});
        emit brokenShown();
    });
    connect(m_mediaStrip, &MessageStrip::actionTriggered, this, [this] {
        emit aboutToRefresh();
        emit m_context.document.changed(ChangeEvent::reset());
    });
    connect(&files.guard(), &ProjectGuard::accessChanged, this, &ProjectStrips::showAccess);
    connect(&files.guard(), &ProjectGuard::changed, this, [this] {
        m_isChanged = true;
        showChanged();
    });
    connect(&files, &ProjectFiles::saved, this, [this] {
        m_isChanged = false;
        showChanged();
    });
    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.touches(Section::Project)) {
            tellBroken();
            showBroken();
        }
        if (event.kind == ChangeEvent::Kind::Reset) {
            m_isChanged = false;
            showChanged();
        }
    });
    connect(&m_media, &MediaWatch::changed, this, &ProjectStrips::showMedia);
    retranslates(this, [this] { retranslate(); });
}

MessageStrip* ProjectStrips::addStrip(const char* name)
{
    auto* strip = new MessageStrip;
    strip->setObjectName(QLatin1String(name));
    layout()->addWidget(strip);
    return strip;
}

void ProjectStrips::showAccess()
{
    using Access = ProjectGuard::Access;
    const QString title = m_context.document.title();
    const QString remedy = tr("Edits can be saved under another name.");
    const ProjectGuard& guard = m_files.guard();
    switch (guard.access()) {
    case Access::Full:
        m_accessStrip->clear();
        break;
    case Access::ReadOnly:
        m_accessStrip->show(
            MessageStrip::Kind::Info,
            tr("“%1” is open read only; it is open elsewhere: %2. %3").arg(title, guard.holder(), remedy));
        break;
    case Access::NotWritable:
        m_accessStrip->show(
            MessageStrip::Kind::Info,
            tr("“%1” is open read only: its folder cannot be written to. %2").arg(title, remedy));
        break;
    case Access::TakenOver:
        m_accessStrip->show(MessageStrip::Kind::Warning,
                            tr("“%1” was taken over: %2. %3").arg(title, guard.holder(), remedy));
        break;
    }
}

void ProjectStrips::showChanged()
{
    if (m_isChanged)
        m_changedStrip->show(
            MessageStrip::Kind::Warning,
            tr("The file of “%1” was changed by another program.").arg(m_context.document.title()));
    else
        m_changedStrip->clear();
}

void ProjectStrips::showBroken()
{
    const auto count = static_cast<int>(m_broken.size());
    if (count > 0)
        m_brokenStrip->show(MessageStrip::Kind::Warning,
                            tr("%n part(s) of the project cannot be read. They stay in its file as they are.",
                               nullptr, count));
    else
        m_brokenStrip->clear();
}

/// In the issues, as long as it is so.
void ProjectStrips::tellBroken()
{
    for (const QString& title : std::as_const(m_broken))
        m_context.issues.clear(title);
    m_broken.clear();
    const std::vector<BrokenEntry> broken = brokenEntries(m_context.document.project());
    const std::vector<std::string> titles = titlesOf(broken);
    for (std::size_t i = 0; i < broken.size(); ++i) {
        m_broken += QString::fromStdString(titles[i]);
        m_context.issues.add(Error(broken[i].problem.code, broken[i].problem.context), m_broken.back(),
                             [this, title = m_broken.back()] {
                                 m_context.selection.select({Section::Project, title});
                                 emit brokenShown();
                             });
    }
}

void ProjectStrips::showMedia()
{
    const QStringList files = m_media.changedFiles();
    if (files.isEmpty()) {
        m_mediaStrip->clear();
        return;
    }
    m_mediaStrip->show(MessageStrip::Kind::Info, tr("%n file(s) of the project changed on disk.", nullptr,
                                                    static_cast<int>(files.size())));
    m_mediaStrip->setToolTip(files.mid(0, 20).join(QLatin1Char('\n')));
}

void ProjectStrips::retranslate()
{
    m_accessStrip->setAction(tr("Save as…"));
    m_changedStrip->setAction(tr("Reload"));
    m_brokenStrip->setAction(tr("Show"));
    m_mediaStrip->setAction(tr("Reload"));
    showAccess();
    showChanged();
    showBroken();
    showMedia();
}

} // namespace quadrille

#include "moc_projectstrips.cpp"

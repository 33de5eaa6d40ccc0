// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/properties/propertiespanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/verticalscroll.h"
#include "editor/language/retranslate.h"
#include "editor/properties/animationpage.h"
#include "editor/properties/appearancepage.h"
#include "editor/properties/brokenpage.h"
#include "editor/properties/characterpage.h"
#include "editor/properties/exportpage.h"
#include "editor/properties/livepage.h"
#include "editor/properties/motionspacepage.h"
#include "editor/properties/projectionpage.h"
#include "editor/properties/projectpage.h"
#include "editor/properties/sequencepage.h"
#include "editor/properties/transferpage.h"
#include "editor/properties/variationpage.h"
#include "widgets/controls/breakable.h"

#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace quadrille {

PropertiesPanel::PropertiesPanel(EditorContext& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_title(new QLabel)
    , m_several(new QLabel)
    , m_pages(new QStackedWidget)
    , m_project(new ProjectPage(context))
    , m_entries{{Section::Characters, new CharacterPage(context)},
                {Section::Sequences, new SequencePage(context)},
                {Section::Animations, new AnimationPage(context)},
                {Section::Variations, new VariationPage(context)},
                {Section::MotionSpaces, new MotionSpacePage(context)},
                {Section::Lives, new LivePage(context)},
                {Section::Appearances, new AppearancePage(context)},
                {Section::Transfers, new TransferPage(context)},
                {Section::Projections, new ProjectionPage(context)},
                {Section::Exports, new ExportPage(context)},
                {Section::Project, new BrokenPage(context)}}
{
    setObjectName(QStringLiteral("propertiesPanel"));
    setMinimumWidth(260);
    m_title->setObjectName(QStringLiteral("propertiesTitle"));
    m_title->setMargin(12);
    m_title->setWordWrap(true);
    QFont bold = m_title->font();
    bold.setWeight(QFont::DemiBold);
    m_title->setFont(bold);
    m_several->setObjectName(QStringLiteral("propertiesSeveral"));
    m_several->setMargin(12);
    m_several->setWordWrap(true);
    m_several->setAlignment(Qt::AlignTop | Qt::AlignLeading);
    m_pages->addWidget(verticalScroll(m_project));
    for (const auto& [section, page] : m_entries)
        m_pages->addWidget(verticalScroll(page));
    m_pages->addWidget(m_several);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_pages, 1);
    connect(&context.selection, &Selection::changed, this, &PropertiesPanel::refresh);
    connect(&context.document, &ProjectDocument::changed, this, &PropertiesPanel::refresh);
    connect(&context.media, &SequenceMedia::changed, this, [this](const QString& name) {
        const EntryRef& current = m_context.selection.current();
        if (current.section == Section::Characters || current == EntryRef{Section::Sequences, name} ||
            m_context.selection.sequences().contains(name))
            refresh();
    });
    retranslates(this, [this] {
        for (int page = 0; page < m_pages->count(); ++page) {
            if (auto* scroll = qobject_cast<QScrollArea*>(m_pages->widget(page)))
                scroll->setMinimumWidth(scroll->widget()->minimumSizeHint().width());
        }
        refresh();
    });
}

PropertyForm* PropertiesPanel::pageOf(const EntryRef& entry) const
{
    // What is shown of the parts of a body is its character.
    const Section section = entry.section == Section::BodyParts ? Section::Characters : entry.section;
    const auto page = m_entries.find(section);
    if (entry.name.isEmpty() || page == m_entries.end() ||
        !findSection(section)->names(m_context.document.project()).contains(entry.name))
        return m_project;
    return page->second;
}

void PropertiesPanel::refresh()
{
    const EntryRef& current = m_context.selection.current();
    if (m_context.selection.sequences().size() > 1) {
        m_title->setText(
            tr("%n sequences", nullptr, static_cast<int>(m_context.selection.sequences().size())));
        m_several->setText(summary());
        m_pages->setCurrentWidget(m_several);
        return;
    }
    PropertyForm* page = pageOf(current);
    m_title->setText(page == m_project ? tr("Project") : widgets::breakable(current.name));
    page->show(page == m_project ? QString() : current.name);
    // Each page stands in a scroll area.
    for (QWidget* place = page; place != nullptr; place = place->parentWidget()) {
        if (m_pages->indexOf(place) >= 0)
            m_pages->setCurrentWidget(place);
    }
}

QString PropertiesPanel::summary() const
{
    std::int64_t frames = 0;
    for (const QString& name : m_context.selection.sequences()) {
        if (const MeshSequence* sequence = m_context.media.sequence(name))
            frames += sequence->frameCount();
    }
    const double seconds = static_cast<double>(frames) / m_context.document.project().settings.fps;
    return tr("%n frames, %1 s", nullptr, static_cast<int>(frames)).arg(QLocale().toString(seconds, 'f', 2)) +
           QLatin1Char('\n') + tr("They are shown beside each other. Select one of them to edit it.");
}

} // namespace quadrille

#include "moc_propertiespanel.cpp"

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/layouts.h"

#include "editor/application/sealedfile.h"
#include "editor/context/actionregistry.h"
#include "editor/language/menutext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/workspacetabs.h"

#include <QDir>
#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>
#include <QStandardPaths>

namespace quadrille {

namespace {

constexpr int layoutsFormat = 1;
constexpr int longestName = 60;

QString layoutsFile()
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation));
    folder.mkpath(QStringLiteral("."));
    return folder.filePath(QStringLiteral("layouts.json"));
}

} // namespace

Layouts::Layouts() : m_all(readSealed(layoutsFile(), layoutsFormat).values["layouts"].toObject()) {}

QStringList Layouts::names(const QString& workspace) const
{
    QStringList names = m_all[workspace].toObject().keys();
    names.sort(Qt::CaseInsensitive);
    return names;
}

QByteArray Layouts::state(const QString& workspace, const QString& name) const
{
    return QByteArray::fromBase64(m_all[workspace].toObject()[name].toString().toLatin1());
}

void Layouts::save(const QString& workspace, const QString& name, const QByteArray& state)
{
    QJsonObject own = m_all[workspace].toObject();
    own[name] = QString::fromLatin1(state.toBase64());
    m_all[workspace] = own;
    write();
}

void Layouts::remove(const QString& workspace, const QString& name)
{
    QJsonObject own = m_all[workspace].toObject();
    own.remove(name);
    m_all[workspace] = own;
    write();
}

void Layouts::write() const
{
    writeSealed(layoutsFile(), {{"layouts", m_all}}, layoutsFormat);
}

LayoutMenu::LayoutMenu(ActionRegistry& actions, WorkspaceTabs& workspaces, QMainWindow& window)
    : QObject(&window), m_actions(actions), m_workspaces(workspaces), m_window(window)
{
    makeActions();
}

void LayoutMenu::makeActions()
{
    const auto view = [] { return tr("View"); };
    m_actions.add({"layout.save",
                   view,
                   [] { return tr("&Save the layout…"); },
                   [] { return tr("Give the arrangement of the panels a name, to come back to it"); },
                   "save",
                   {}},
                  [this] { askName(); });
    m_actions.add({"layout.reset",
                   view,
                   [] { return tr("&Reset the layout"); },
                   [] { return tr("Put the panels of this workspace where they were at first"); },
                   "undo",
                   {}},
                  [this] { m_workspaces.resetArrangement(); });
}

void LayoutMenu::fill(QMenu& menu)
{
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] { refill(menu); });
    retranslates(&m_window, [this, &menu] { refill(menu); });
    refill(menu);
}

void LayoutMenu::refill(QMenu& menu)
{
    menu.clear();
    delete m_removal; // a menu does not delete those below it
    const QString workspace = m_workspaces.current();
    const QStringList names = m_layouts.names(workspace);
    for (const QString& name : names)
        menu.addAction(menuText(name), this, [this, workspace, name] {
            m_workspaces.setArrangement(m_layouts.state(workspace, name));
        });
    menu.addSeparator();
    menu.addAction(m_actions.action("layout.save"));
    m_removal = menu.addMenu(tr("&Delete"));
    m_removal->setObjectName(QStringLiteral("layoutRemoval"));
    m_removal->setEnabled(!names.isEmpty());
    for (const QString& name : names)
        m_removal->addAction(menuText(name), this,
                             [this, workspace, name] { m_layouts.remove(workspace, name); });
    menu.addAction(m_actions.action("layout.reset"));
}

void LayoutMenu::askName()
{
    auto* dialog = new QInputDialog(&m_window);
    dialog->setObjectName(QStringLiteral("layoutName"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save the layout"));
    dialog->setLabelText(tr("Name of the layout; one that is there already is replaced:"));
    dialog->setComboBoxEditable(true);
    const QString workspace = m_workspaces.current();
    dialog->setComboBoxItems(m_layouts.names(workspace));
    dialog->setTextValue(QString());
    connect(dialog, &QInputDialog::textValueSelected, this, [this, workspace](const QString& entered) {
        const QString name = entered.simplified().left(longestName);
        if (!name.isEmpty())
            m_layouts.save(workspace, name, m_workspaces.arrangement());
    });
    dialog->open();
}

} // namespace quadrille

#include "moc_layouts.cpp"

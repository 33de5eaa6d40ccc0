// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/preferences/aboutdialog.h"

#include "widgets/theme/icons.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSysInfo>
#include <QVBoxLayout>

namespace quadrille {

namespace {

QString versions()
{
    return QStringLiteral("Quadrille %1\nQt %2\n%3")
        .arg(QApplication::applicationVersion(), QLatin1String(qVersion()), QSysInfo::prettyProductName());
}

} // namespace

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("aboutDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("About Quadrille"));
    auto* logo = new QLabel;
    logo->setPixmap(widgets::icons::application().pixmap(64));
    auto* title = new QLabel(QStringLiteral("Quadrille ") + QApplication::applicationVersion());
    QFont heading = title->font();
    heading.setPointSizeF(heading.pointSizeF() * 1.5);
    heading.setWeight(QFont::DemiBold);
    title->setFont(heading);
    auto* text =
        new QLabel(tr("An editor for 4D performance capture: makes new performances from captured ones.") +
                   QStringLiteral("\n\n") + tr("Free software under the MIT licence."));
    text->setWordWrap(true);
    auto* libraries = new QLabel(
        tr("Built on %1.")
            .arg(QStringLiteral(
                "Qt 6 (LGPL), VTK (BSD), OpenCV (Apache), libjpeg-turbo (BSD), OpenMesh (BSD), Eigen "
                "(MPL), oneTBB (Apache), HDF5 (BSD), assimp (BSD), nlohmann/json "
                "(MIT), nanoflann (BSD), CLI11 (BSD), xxHash (BSD), zlib, FreeType")));
    libraries->setWordWrap(true);
    libraries->setForegroundRole(QPalette::PlaceholderText);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* copy = buttons->addButton(tr("Copy versions"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("aboutCopy"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(24, 24, 24, 16);
    column->setSpacing(12);
    for (QWidget* widget : std::initializer_list<QWidget*>{logo, title, text, libraries, buttons})
        column->addWidget(widget);
    setFixedWidth(440);
    connect(copy, &QPushButton::clicked, this, [] { QApplication::clipboard()->setText(versions()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
}

} // namespace quadrille

#include "moc_aboutdialog.cpp"

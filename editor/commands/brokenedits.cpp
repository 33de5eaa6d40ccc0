// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/brokenedits.h"

#include "editor/commands/changeproject.h"
#include "editor/documents/editcheck.h"
#include "editor/documents/projectpaths.h"
#include "model/project/file/usableproject.h"
#include "model/project/json/keptjson.h"

#include <QCoreApplication>
#include <algorithm>

namespace quadrille {

namespace {

struct BrokenTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::BrokenEdits)
};

} // namespace

void removeBroken(ProjectDocument& document, const QStringList& titles)
{
    Project after = document.project();
    std::vector<BrokenEntry> broken = brokenEntries(after);
    const std::vector<std::string> all = titlesOf(broken);
    for (std::size_t i = all.size(); i-- > 0;) {
        if (titles.contains(QString::fromStdString(all[i])))
            broken.erase(broken.begin() + static_cast<std::ptrdiff_t>(i));
    }
    setBrokenEntries(after, broken);
    const int count = static_cast<int>(titles.size());
    const QString text = count == 1 ? BrokenTexts::tr("Remove “%1”").arg(titles.front())
                                    : BrokenTexts::tr("Remove %n unreadable parts", nullptr, count);
    document.push(std::make_unique<ChangeProject>(document, text, std::move(after)));
}

bool setBroken(ProjectDocument& document, const QString& title, const QString& json)
{
    // Paths of what cannot be read are as in the file.
    Project changed = document.snapshot();
    std::vector<BrokenEntry> broken = brokenEntries(changed);
    const std::vector<std::string> titles = titlesOf(broken);
    const auto found = std::ranges::find(titles, title.toStdString());
    if (found == titles.end())
        return false;
    try {
        broken[static_cast<std::size_t>(found - titles.begin())].json = keptFromText(json.toStdString());
        setBrokenEntries(changed, broken);
        const std::filesystem::path file = document.workingFile();
        changed = withAbsolutePaths(withBrokenReadAgain(changed, file), file.parent_path());
    } catch (const Error& error) {
        EditRefusals::of(document).refuse(error);
        return false;
    }
    return wasTaken(document, std::make_unique<ChangeProject>(
                                  document, BrokenTexts::tr("Correct “%1”").arg(title), std::move(changed)));
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/exports/exportclaims.h"

#include "model/core/error.h"
#include "model/core/seriesname.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/exports/dataset.h"
#include "model/project/exports/exportentry.h"
#include "model/sequence/io/registry.h"

#include <algorithm>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

class Claims
{
public:
    void addFile(const fs::path& file, bool isCompanion = false)
    {
        claims.push_back(
            {{resolvedFolder(file.parent_path()), file.filename().string(), {}}, false, isCompanion});
    }
    void addSeries(const fs::path& folder, std::string before, std::string after, bool isCompanion = false)
    {
        claims.push_back({{resolvedFolder(folder), std::move(before), std::move(after)}, true, isCompanion});
    }

    void addFramePictures(const fs::path& out)
    {
        for (const char* ending : {".png", ".jpg"})
            addSeries(out.parent_path() / "textures" / seriesStem(out), "", ending, true);
    }

    /// See copyTextures, and the libraries of OBJ files.
    void addCompanions(const FormatInfo& format, const fs::path& out)
    {
        const fs::path folder = out.parent_path();
        const std::string stem = seriesStem(out);
        for (const char* ending : {".png", ".jpg"}) {
            addFile(folder / (stem + "_texture" + ending), true);
            addSeries(folder, stem + "_texture", ending, true);
        }
        addFramePictures(out);
        if (format.id != "obj")
            return;
        addFile(folder / (stem + ".mtl"), true);
        const SeriesName name = seriesName(out);
        addSeries(folder, name.before, fs::path(name.after).replace_extension(".mtl").string(), true);
    }

    void addClip(const FormatInfo& format, const fs::path& out, bool textures)
    {
        if (format.onePerFrame) {
            const SeriesName name = seriesName(out);
            addSeries(out.parent_path(), name.before, name.after);
        } else {
            addFile(out);
        }
        if (format.texturesBeside && textures)
            addCompanions(format, out);
        if (format.frameTexturesBeside && textures)
            addFramePictures(out);
    }

    std::vector<OutputClaim> claims;
};

bool meet(const OutputClaim& a, const OutputClaim& b)
{
    if (a.names.folder != b.names.folder)
        return false;
    if (!a.isNumbered && !b.isNumbered)
        return a.names.before == b.names.before;
    if (a.isNumbered && b.isNumbered)
        return a.names.before == b.names.before && a.names.after == b.names.after;
    return a.isNumbered ? a.names.contains(b.names.before) : b.names.contains(a.names.before);
}

} // namespace

std::string OutputClaim::text() const
{
    return isNumbered ? names.before + "0000" + names.after + " …" : names.before;
}

std::vector<OutputClaim> claimsOf(const Project& project, const ExportEntry& entry, const fs::path& folder)
{
    const FormatInfo& format = exporterOf(entry).format();
    const fs::path out = resolvedPlace(resolvePath(entry.path, folder));
    checkOutputName(format, out);
    Claims claims;
    if (!isDataSet(entry)) {
        claims.addClip(format, out, entry.textures);
        return std::move(claims.claims);
    }
    const VariationEntry* variation = findVariation(project, variationOfClip(entry.what)->variation);
    if (variation == nullptr)
        return {};
    for (int number = 1; number <= variationCount(*variation); ++number) {
        if (!isDiscarded(*variation, number))
            claims.addClip(format, dataSetMember(out, number), entry.textures);
    }
    for (const std::string& part : partNamesOf(project, *variation))
        claims.addFile(dataSetLatents(out, part));
    claims.addFile(dataSetDescription(out));
    return std::move(claims.claims);
}

std::optional<std::string> sharedOutput(const Project& project, const ExportEntry& a, const ExportEntry& b,
                                        const fs::path& folder)
{
    const auto first = claimsOf(project, a, folder);
    const auto second = claimsOf(project, b, folder);
    for (const OutputClaim& one : first) {
        for (const OutputClaim& other : second) {
            const bool arePictures = one.isCompanion && other.isCompanion && a.what == b.what;
            if (!arePictures && meet(one, other))
                return one.isNumbered ? other.text() : one.text();
        }
    }
    return std::nullopt;
}

void checkOutputs(const Project& project, const ExportEntry& entry, const std::vector<ExportEntry>& others,
                  const fs::path& folder, WriteGuard& guard)
{
    for (const OutputClaim& claim : claimsOf(project, entry, folder)) {
        if (claim.isNumbered)
            guard.checkSeries(claim.names);
        else
            guard.checkPlace(claim.names.folder / claim.names.before);
    }
    for (const ExportEntry& other : others) {
        if (other.name == entry.name && other.what == entry.what)
            continue;
        std::optional<std::string> shared;
        try {
            shared = sharedOutput(project, entry, other, folder);
        } catch (const Error&) {
            continue; // the other is what is wrong, and says so itself
        }
        if (shared)
            refuseTwice(resolvePath(entry.path, folder), *shared, "exports/" + other.name);
    }
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/formats.h"

#include "model/sequence/io/anime.h"
#include "model/sequence/io/clipexport.h"
#include "model/sequence/io/gltf/glbwriter.h"
#include "model/sequence/io/gltf/gltf.h"
#include "model/sequence/io/hdf5sequence.h"
#include "model/sequence/io/mdd.h"
#include "model/sequence/io/mesh/obj.h"
#include "model/sequence/io/mesh/off.h"
#include "model/sequence/io/mesh/ply.h"
#include "model/sequence/io/mesh/stl.h"
#include "model/sequence/io/npy.h"
#include "model/sequence/io/pc2.h"
#include "model/sequence/io/playerformat.h"
#include "model/sequence/io/scene/assimpscene.h"
#include "model/sequence/io/usdwriter.h"

namespace quadrille {

std::vector<std::unique_ptr<Importer>> makeImporters()
{
    std::vector<std::unique_ptr<Importer>> importers;
    importers.push_back(makeObjImporter());
    importers.push_back(makePlyImporter());
    importers.push_back(makeOffImporter());
    importers.push_back(makeStlImporter());
    importers.push_back(makePc2Importer());
    importers.push_back(makeMddImporter());
    importers.push_back(makeNpyImporter());
    importers.push_back(std::make_unique<GltfImporter>());
    importers.push_back(std::make_unique<FbxImporter>());
    importers.push_back(std::make_unique<ColladaImporter>());
    importers.push_back(std::make_unique<AnimeImporter>());
    importers.push_back(std::make_unique<Hdf5Importer>());
    return importers;
}

std::vector<std::unique_ptr<Exporter>> makeExporters()
{
    std::vector<std::unique_ptr<Exporter>> exporters;
    exporters.push_back(makeObjExporter());
    exporters.push_back(makePlyExporter());
    exporters.push_back(makePc2Exporter());
    exporters.push_back(makeMddExporter());
    exporters.push_back(makeNpyExporter());
    exporters.push_back(std::make_unique<GlbExporter>());
    exporters.push_back(std::make_unique<UsdExporter>());
    exporters.push_back(std::make_unique<PlayerExporter>());
    exporters.push_back(makePngExporter());
    exporters.push_back(makeVideoExporter());
    return exporters;
}

} // namespace quadrille

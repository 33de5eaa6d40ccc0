// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The English sentences of every error and issue, and nothing else: the editor's catalogues translate them.
#include "model/core/error.h"
#include "model/core/message.h"

namespace quadrille {

ErrorMessage errorMessage(ErrorCode code)
{
    switch (code) {
    case ErrorCode::Cancelled:
        return {QUADRILLE_MESSAGE("Cancelled."), ""};
    case ErrorCode::FileNotFound:
        return {QUADRILLE_MESSAGE("There is no such file or folder."),
                QUADRILLE_MESSAGE("Check the path, or use “Find missing files” in the editor.")};
    case ErrorCode::PermissionDenied:
        return {QUADRILLE_MESSAGE("You do not have permission to use this file."),
                QUADRILLE_MESSAGE("Change its permissions or choose another place.")};
    case ErrorCode::ReadFailed:
        return {QUADRILLE_MESSAGE("Reading failed: {reason}."),
                QUADRILLE_MESSAGE("Check the disk and try again.")};
    case ErrorCode::WriteFailed:
        return {QUADRILLE_MESSAGE("Writing failed: {reason}."),
                QUADRILLE_MESSAGE("Check free space and permissions, then try again.")};
    case ErrorCode::FileEmpty:
        return {QUADRILLE_MESSAGE("The file is empty."), QUADRILLE_MESSAGE("Export it again.")};
    case ErrorCode::FileTruncated:
        return {QUADRILLE_MESSAGE("The file ends too early: {expected} expected, {found} found."),
                QUADRILLE_MESSAGE("Export or copy it again.")};
    case ErrorCode::FileEncoding:
        return {QUADRILLE_MESSAGE("The file is not text in UTF-8."),
                QUADRILLE_MESSAGE("Save it again as plain text in UTF-8.")};
    case ErrorCode::FileSyntax:
        return {QUADRILLE_MESSAGE("This is not what the format allows here: {reason}."),
                QUADRILLE_MESSAGE("Export it again, or correct this place.")};
    case ErrorCode::CountTooLarge:
        return {QUADRILLE_MESSAGE("The header promises {count} {what}, more than the file can hold."),
                QUADRILLE_MESSAGE("The file is damaged or of another format; export it again.")};
    case ErrorCode::FormatUnknown:
        return {QUADRILLE_MESSAGE("The format of this file is not known."),
                QUADRILLE_MESSAGE("Convert it to OBJ, PLY, PC2 or GLB.")};
    case ErrorCode::FormatRefused:
        return {QUADRILLE_MESSAGE("{format} cannot be read here."), QUADRILLE_MESSAGE("{remedy}")};
    case ErrorCode::FormatNeedsMesh:
        return {QUADRILLE_MESSAGE("This file holds positions only; a mesh with its faces is needed."),
                QUADRILLE_MESSAGE("Give the mesh (OBJ or PLY) of the same vertex order with it.")};
    case ErrorCode::FormatCannotStore:
        return {QUADRILLE_MESSAGE("{format} cannot hold {what}."),
                QUADRILLE_MESSAGE("Choose another format.")};
    case ErrorCode::SeriesEmpty:
        return {QUADRILLE_MESSAGE("No numbered mesh files were found here."),
                QUADRILLE_MESSAGE("Choose a folder or pattern that holds NAME_0001.obj, NAME_0002.obj, …")};
    case ErrorCode::SeriesAmbiguous:
        return {QUADRILLE_MESSAGE("It is not clear which files are meant: {found}."),
                QUADRILLE_MESSAGE("Name one file, or one series by a pattern such as NAME_####.obj.")};
    case ErrorCode::NoVertices:
        return {QUADRILLE_MESSAGE("The mesh has no vertices."),
                QUADRILLE_MESSAGE("Export it again with geometry.")};
    case ErrorCode::NoFaces:
        return {QUADRILLE_MESSAGE("The mesh has no faces."),
                QUADRILLE_MESSAGE("Export it with faces, or give a mesh beside it.")};
    case ErrorCode::SceneWithoutMesh:
        return {QUADRILLE_MESSAGE("The scene holds no mesh."),
                QUADRILLE_MESSAGE("Export the character's geometry too: cameras, lights and bones alone "
                                  "cannot be shown.")};
    case ErrorCode::PolygonSoup:
        return {QUADRILLE_MESSAGE("The {count} triangles share no vertices: this is a polygon soup."),
                QUADRILLE_MESSAGE("Merge vertices by distance in the tool it comes from, and export again.")};
    case ErrorCode::IndexOutOfRange:
        return {QUADRILLE_MESSAGE("A face names {what} {index}, but there are only {count}."),
                QUADRILLE_MESSAGE("Export it again, or correct this face.")};
    case ErrorCode::NonFiniteCoordinate:
        return {QUADRILLE_MESSAGE("Vertex {vertex} has a coordinate that is not a finite number."),
                QUADRILLE_MESSAGE("Leave this frame out by the range, or repair it.")};
    case ErrorCode::VertexCountMismatch:
        return {QUADRILLE_MESSAGE("{found} vertices where {expected} are expected."),
                QUADRILLE_MESSAGE(
                    "All frames and the mesh of a sequence need the same vertices in the same order.")};
    case ErrorCode::TopologyMismatch:
        return {QUADRILLE_MESSAGE("The topology differs from the first frame: {what}."),
                QUADRILLE_MESSAGE(
                    "A sequence needs one topology; leave this frame out or track the capture first.")};
    case ErrorCode::RangeOutside:
        return {QUADRILLE_MESSAGE("Frames {first} to {last} were asked for, but there are only {count}."),
                QUADRILLE_MESSAGE("Choose a range inside 0 to the last frame.")};
    case ErrorCode::NoUvs:
        return {QUADRILLE_MESSAGE("The mesh has no texture coordinates."),
                QUADRILLE_MESSAGE("Export it with UVs, or go on without a texture.")};
    case ErrorCode::ImageUnreadable:
        return {QUADRILLE_MESSAGE("The picture cannot be read."),
                QUADRILLE_MESSAGE("Save it as PNG, JPEG or TIFF.")};
    case ErrorCode::ImageCountMismatch:
        return {QUADRILLE_MESSAGE("{found} textures for {expected} frames."),
                QUADRILLE_MESSAGE("Give one texture, or one for each frame.")};
    case ErrorCode::ProjectSyntax:
        return {QUADRILLE_MESSAGE("This is not valid JSON: {reason}."),
                QUADRILLE_MESSAGE("Correct this place.")};
    case ErrorCode::ProjectInvalid:
        return {QUADRILLE_MESSAGE("{reason}."), QUADRILLE_MESSAGE("{remedy}")};
    case ErrorCode::ProjectNewer:
        return {
            QUADRILLE_MESSAGE("The project has version {found}; this program knows versions up to {known}."),
            QUADRILLE_MESSAGE("Open it with a newer Quadrille.")};
    case ErrorCode::ProjectMissingMedia:
        return {QUADRILLE_MESSAGE("“{what}” uses a file that is not there: {path}."),
                QUADRILLE_MESSAGE("Put it back, or use “Find missing files” in the editor.")};
    case ErrorCode::ProjectUnknownTarget:
        return {QUADRILLE_MESSAGE("The project has no target “{what}”."),
                QUADRILLE_MESSAGE("It has: {known}.")};
    case ErrorCode::ProjectUnknownData:
        return {QUADRILLE_MESSAGE("The project has no data “{what}”."),
                QUADRILLE_MESSAGE("It has: {known}.")};
    case ErrorCode::ResultDamaged:
        return {QUADRILLE_MESSAGE("A stored result is damaged."),
                QUADRILLE_MESSAGE("It will be computed again.")};
    case ErrorCode::ResultReplaced:
        return {QUADRILLE_MESSAGE("The result “{stage}” was replaced while it was being used."),
                QUADRILLE_MESSAGE("Another rebuild of the project is under way; try again once it is done.")};
    case ErrorCode::BadArgument:
        return {QUADRILLE_MESSAGE("{reason}."), QUADRILLE_MESSAGE("{remedy}")};
    case ErrorCode::OutOfMemory:
        return {QUADRILLE_MESSAGE("There is not enough memory for this."),
                QUADRILLE_MESSAGE("Choose a shorter range, or close other programs.")};
    case ErrorCode::Unexpected:
        return {QUADRILLE_MESSAGE("Something unexpected happened inside the program ({detail})."),
                QUADRILLE_MESSAGE("Save your work and try again; if it happens again, report it.")};
    case ErrorCode::CharacterTopologyMismatch:
        return {QUADRILLE_MESSAGE("“{sequence}” has another topology than “{first}”: {what}."),
                QUADRILLE_MESSAGE("The sequences of a character share one topology; leave this one out.")};
    case ErrorCode::NoUsableTriangles:
        return {QUADRILLE_MESSAGE("Every triangle is without area in some frame."),
                QUADRILLE_MESSAGE("Leave collapsed frames out by the range.")};
    case ErrorCode::NoTransition:
        return {
            QUADRILLE_MESSAGE("There is no transition from frame {source} to frame {destination}: it needs "
                              "{needed} frames from the one on and up to the other; their sequences have "
                              "{after} and {before}."),
            QUADRILLE_MESSAGE("Leave earlier, arrive later, or allow shorter windows.")};
    case ErrorCode::LoopTooShort:
        return {QUADRILLE_MESSAGE("The clip has {frames} frames; a loop needs at least {needed}."),
                QUADRILLE_MESSAGE("Take a longer clip, or allow shorter transitions.")};
    case ErrorCode::LoopCutTooShort:
        return {
            QUADRILLE_MESSAGE("A loop needs to cut at least {needed} frames from each end of the clip, to "
                              "blend them; {given} are allowed."),
            QUADRILLE_MESSAGE("Allow more to be cut, or shorter transitions.")};
    case ErrorCode::TimeCurveNotMonotone:
        return {QUADRILLE_MESSAGE("The curve of times goes back at its point {point}."),
                QUADRILLE_MESSAGE("Output times must rise, and clip times must not fall.")};
    case ErrorCode::NoSymmetry:
        return {
            QUADRILLE_MESSAGE("No left–right symmetry of the mesh was found: {share} % of its vertices have "
                              "a counterpart on the other side."),
            QUADRILLE_MESSAGE("Give a symmetry map, or an upright pose to find it in.")};
    case ErrorCode::SymmetryMapWrong:
        return {QUADRILLE_MESSAGE("The symmetry map does not fit the mesh: {reason}."),
                QUADRILLE_MESSAGE("Give for each vertex the index of its counterpart, or its own.")};
    case ErrorCode::NoFeet:
        return {QUADRILLE_MESSAGE("No feet were found to stand on."),
                QUADRILLE_MESSAGE("Contacts can be corrected where legs hang apart from the body; leave this "
                                  "step out.")};
    case ErrorCode::WalkKeyOrder:
        return {QUADRILLE_MESSAGE("Key {key} is wanted at {time}, not after key {other}, which is wanted at "
                                  "{otherTime}."),
                QUADRILLE_MESSAGE("Give keys in the order of their times, no two at one time.")};
    case ErrorCode::WalkKeyUnreachable:
        return {QUADRILLE_MESSAGE("Key {key} cannot be reached: no walk leads to frame {frame}."),
                QUADRILLE_MESSAGE("The nearest frame that can be reached is {nearest}; take it, or change "
                                  "what comes before.")};
    case ErrorCode::WalkKeyUntimely:
        return {QUADRILLE_MESSAGE("Key {key} cannot be met within {tolerance} frames of {time}."),
                QUADRILLE_MESSAGE("The nearest time at which it can is {nearest}; allow a greater error, or "
                                  "change times.")};
    case ErrorCode::WalkFramesMissing:
        return {QUADRILLE_MESSAGE("No frame of this character is “{name}”."),
                QUADRILLE_MESSAGE("Label some, or ask for something else.")};
    case ErrorCode::WalkActionImpossible:
        return {QUADRILLE_MESSAGE("“{name}” cannot be performed: {share} % of a span are asked for, and no "
                                  "walk plays more than {most} %."),
                QUADRILLE_MESSAGE("Ask for at most {most} %, or allow shorter transitions.")};
    case ErrorCode::WalkPathShort:
        return {QUADRILLE_MESSAGE("The path is {length} m long, too short for a walk."),
                QUADRILLE_MESSAGE("Draw at least {needed} m.")};
    case ErrorCode::WalkSpanOutside:
        return {QUADRILLE_MESSAGE("A span of the path goes from {from} m to {to} m, but the path has "
                                  "{length} m."),
                QUADRILLE_MESSAGE("Move the span, or draw a longer path.")};
    case ErrorCode::WalkObstacleAtStart:
        return {QUADRILLE_MESSAGE("The path begins in “{name}”, or too close to it."),
                QUADRILLE_MESSAGE("Move one of them; the path is free from {free} m on.")};
    case ErrorCode::WalkPathBlocked:
        return {QUADRILLE_MESSAGE("No walk was found that gets past “{name}” at {reached} m of the path."),
                QUADRILLE_MESSAGE("Lead the path around it, leave more room, or search with a greater "
                                  "budget.")};
    case ErrorCode::WalkDemandUnmet:
        return {QUADRILLE_MESSAGE("No walk was found that shows “{name}” from {from} m to {to} m of the "
                                  "path; the best one fails at {reached} m."),
                QUADRILLE_MESSAGE("End the span at {reached} m, or search with a greater budget.")};
    case ErrorCode::WalkNotFound:
        return {QUADRILLE_MESSAGE("No walk was found with {budget} expansions."),
                QUADRILLE_MESSAGE("Search with a greater budget, or ask for less.")};
    case ErrorCode::WalkPathImpassable:
        return {QUADRILLE_MESSAGE("No walk gets past “{name}” at {reached} m of the path; every way was "
                                  "tried."),
                QUADRILLE_MESSAGE("Lead the path around it, or leave more room.")};
    case ErrorCode::WalkDemandImpossible:
        return {QUADRILLE_MESSAGE("No walk shows “{name}” from {from} m to {to} m of the path; the best one "
                                  "fails at {reached} m, and every way was tried."),
                QUADRILLE_MESSAGE("End the span at {reached} m, or demand other frames.")};
    case ErrorCode::WalkImpossible:
        return {QUADRILLE_MESSAGE("No walk does all that is asked at once; every way was tried."),
                QUADRILLE_MESSAGE("Take back a chosen, locked or banned transition, or ask for less.")};
    case ErrorCode::TakeTooShort:
        return {
            QUADRILLE_MESSAGE("“{take}” has {count} frames; variations are learned from takes of {least} or "
                              "more."),
            QUADRILLE_MESSAGE("Choose another take, or more of its frames.")};
    case ErrorCode::CurveVertexOutside:
        return {QUADRILLE_MESSAGE("The curve “{curve}” names vertex {vertex}, but the mesh has {vertices}."),
                QUADRILLE_MESSAGE("It may come from another mesh; draw it again.")};
    case ErrorCode::CurveShort:
        return {
            QUADRILLE_MESSAGE("The curve “{curve}” has {found} vertices; a closed curve needs at least 3."),
            QUADRILLE_MESSAGE("Add points, or delete the curve.")};
    case ErrorCode::CurveOpen:
        return {QUADRILLE_MESSAGE(
                    "The curve “{curve}” is open: no edge leads from vertex {from} to vertex {to}."),
                QUADRILLE_MESSAGE("Add points there. If it is open in many places, it may come from another "
                                  "mesh; draw it again.")};
    case ErrorCode::CurveMeetsItself:
        return {QUADRILLE_MESSAGE("The curve “{curve}” meets itself at vertex {vertex}."),
                QUADRILLE_MESSAGE("Move the points near there apart.")};
    case ErrorCode::CurveMeetsOther:
        return {QUADRILLE_MESSAGE("The curve “{curve}” meets the curve “{other}” at vertex {vertex}."),
                QUADRILLE_MESSAGE("Move one of them away.")};
    case ErrorCode::CurveDoesNotSeparate:
        return {QUADRILLE_MESSAGE("The curve “{curve}” does not cut the mesh in two."),
                QUADRILLE_MESSAGE("Lead it once around a limb. Where a limb touches the body and has grown "
                                  "together with it, no curve can; take a mesh in another pose.")};
    case ErrorCode::CurveNameTaken:
        return {QUADRILLE_MESSAGE("There are two curves “{curve}”."),
                QUADRILLE_MESSAGE("Rename one of them.")};
    case ErrorCode::CurvePointTwice:
        return {QUADRILLE_MESSAGE("The curve has a point at vertex {vertex} already."),
                QUADRILLE_MESSAGE("Choose another place, or drag that point.")};
    case ErrorCode::CurvePointTaken:
        return {QUADRILLE_MESSAGE("Another curve passes through vertex {vertex}."),
                QUADRILLE_MESSAGE("Choose a place beside it.")};
    case ErrorCode::CurveNoRoute:
        return {QUADRILLE_MESSAGE(
                    "Nothing leads from vertex {from} to vertex {to} but through other curves or this one."),
                QUADRILLE_MESSAGE("Move the points, or the curves between them.")};
    case ErrorCode::CurveNoParallel:
        return {QUADRILLE_MESSAGE("There is no curve {distance} m beside this one: the surface ends before, "
                                  "or other curves are in the way."),
                QUADRILLE_MESSAGE("Choose a smaller distance.")};
    case ErrorCode::CurveBoundsNothing:
        return {
            QUADRILLE_MESSAGE("This curve does not cut the mesh in two, so there is nothing to draw it tight "
                              "around, and no side to lay another on."),
            QUADRILLE_MESSAGE("Lead it once around a limb first.")};
    case ErrorCode::PartNameTaken:
        return {QUADRILLE_MESSAGE("There are two parts “{part}”."), QUADRILLE_MESSAGE("Rename one of them.")};
    case ErrorCode::PartRootMissing:
        return {QUADRILLE_MESSAGE(
                    "Every part hangs on another one; the part that all others hang on is missing."),
                QUADRILLE_MESSAGE("Add it, with neither parent nor curves.")};
    case ErrorCode::PartRootTwice:
        return {QUADRILLE_MESSAGE("Both “{part}” and “{other}” have no parent."),
                QUADRILLE_MESSAGE("Let one of them hang on another part.")};
    case ErrorCode::PartParentUnknown:
        return {QUADRILLE_MESSAGE("The part “{part}” hangs on “{parent}”, which does not exist."),
                QUADRILLE_MESSAGE("Choose one of the parts that exist.")};
    case ErrorCode::PartCycle:
        return {QUADRILLE_MESSAGE("The part “{part}” hangs on itself, by way of others."),
                QUADRILLE_MESSAGE("Choose another parent.")};
    case ErrorCode::PartCurveCount:
        return {QUADRILLE_MESSAGE("The part “{part}” has {found} curves; it needs {needed}."),
                QUADRILLE_MESSAGE("A part that hangs on another has two, around what they share; the one "
                                  "that all hang on has none.")};
    case ErrorCode::PartCurveUnknown:
        return {QUADRILLE_MESSAGE("The part “{part}” uses the curve “{curve}”, which does not exist."),
                QUADRILLE_MESSAGE("Draw it, or choose another.")};
    case ErrorCode::PartCurveShared:
        return {QUADRILLE_MESSAGE("Both “{part}” and “{other}” use the curve “{curve}”."),
                QUADRILLE_MESSAGE("Give each part two curves of its own.")};
    case ErrorCode::PartCurvesApart:
        return {QUADRILLE_MESSAGE(
                    "The curves “{curve}” and “{other}” of the part “{part}” bound no ring together."),
                QUADRILLE_MESSAGE("Draw both around the same limb, with no other curve between them.")};
    case ErrorCode::PartMisplaced:
        return {QUADRILLE_MESSAGE("The part “{part}” does not lie next to “{parent}”, on which it hangs."),
                QUADRILLE_MESSAGE("Choose the part beyond its curves as parent.")};
    case ErrorCode::PartEmpty:
        return {QUADRILLE_MESSAGE("The part “{part}” has no vertices beyond what it shares with others."),
                QUADRILLE_MESSAGE("Move its curves away from the limb's end, or from other curves.")};
    case ErrorCode::PartsNoLimbs:
        return {
            QUADRILLE_MESSAGE("No two arms and two legs were found: {found} limbs stick out."),
            QUADRILLE_MESSAGE("Draw the curves by hand, or choose a pose in which arms and legs stick out.")};
    case ErrorCode::PartsLimbGrown:
        return {QUADRILLE_MESSAGE("No curve around “{limb}” cuts it off: it seems to touch another place of "
                                  "the body and to have grown together with it."),
                QUADRILLE_MESSAGE(
                    "Draw the other curves by hand, or take a mesh in a pose in which it touches nothing.")};
    case ErrorCode::PartsNotCut:
        return {QUADRILLE_MESSAGE("No room for two curves around “{limb}” was found."),
                QUADRILLE_MESSAGE("Draw the curves by hand, or ask for narrower overlaps.")};
    case ErrorCode::VariationMissing:
        return {QUADRILLE_MESSAGE("There is no variation {number}: too few of those drawn were good enough."),
                QUADRILLE_MESSAGE("Draw with another seed, or allow more in the limits.")};
    case ErrorCode::TransferNoPairs:
        return {QUADRILLE_MESSAGE("No triangles are paired."),
                QUADRILLE_MESSAGE("Pair triangles of the template with those of the target.")};
    case ErrorCode::TransferTriangleOfTemplate:
        return {QUADRILLE_MESSAGE(
                    "Pair {pair} names triangle {triangle} of the template, which has only {count}."),
                QUADRILLE_MESSAGE("Pair it again: the mesh has changed.")};
    case ErrorCode::TransferTriangleOfTarget:
        return {
            QUADRILLE_MESSAGE("Pair {pair} names triangle {triangle} of the target, which has only {count}."),
            QUADRILLE_MESSAGE("Pair it again: the mesh has changed.")};
    case ErrorCode::TransferTriangleTwice:
        return {QUADRILLE_MESSAGE("Triangle {triangle} of the target is in two pairs."),
                QUADRILLE_MESSAGE("Remove one of them.")};
    case ErrorCode::TransferTriangleFlat:
        return {QUADRILLE_MESSAGE("Triangle {triangle} of the target has no area."),
                QUADRILLE_MESSAGE("Pair one beside it.")};
    case ErrorCode::TransferNoLimbsOfTemplate:
        return {
            QUADRILLE_MESSAGE(
                "No two arms and two legs were found on the template, by which pairs of triangles "
                "could be proposed."),
            QUADRILLE_MESSAGE("Pair triangles by hand, or take a pose in which arms and legs stick out.")};
    case ErrorCode::TransferNoLimbsOfTarget:
        return {
            QUADRILLE_MESSAGE(
                "No two arms and two legs were found on the target, by which pairs of triangles "
                "could be proposed."),
            QUADRILLE_MESSAGE("Pair triangles by hand, or take a pose in which arms and legs stick out.")};
    }
    return {"", ""};
}

ErrorMessage issueMessage(Issue::Code code)
{
    switch (code) {
    case Issue::Code::NumberingGap:
        return {QUADRILLE_MESSAGE("The numbering has gaps: {missing}."),
                QUADRILLE_MESSAGE("The frames that exist are used, one after the other.")};
    case Issue::Code::PolygonsTriangulated:
        return {QUADRILLE_MESSAGE("{count} polygons with more than three corners were cut into triangles."),
                ""};
    case Issue::Code::NonManifoldEdges:
        return {QUADRILLE_MESSAGE("{count} edges have more than two triangles."), ""};
    case Issue::Code::DegenerateTriangles:
        return {QUADRILLE_MESSAGE("{count} triangles have no area."), ""};
    case Issue::Code::UnusedVertices:
        return {QUADRILLE_MESSAGE("{count} vertices belong to no triangle."), ""};
    case Issue::Code::DuplicateFaces:
        return {QUADRILLE_MESSAGE("{count} triangles name the same vertex twice and were left out."), ""};
    case Issue::Code::TextureMissing:
        return {QUADRILLE_MESSAGE("The texture {path} was not found."),
                QUADRILLE_MESSAGE("The mesh is shown without it.")};
    case Issue::Code::TextureCountDiffers:
        return {QUADRILLE_MESSAGE("{found} textures in {path} for {expected} frames."),
                QUADRILLE_MESSAGE("They are not used.")};
    case Issue::Code::MeshFound:
        return {QUADRILLE_MESSAGE("Faces and texture coordinates are those of {path}."), ""};
    case Issue::Code::FpsAssumed:
        return {QUADRILLE_MESSAGE("The source names no frame rate; {fps} fps is assumed."), ""};
    case Issue::Code::FpsResampled:
        return {QUADRILLE_MESSAGE("Resampled from {from} to {to} fps."), ""};
    case Issue::Code::VerticesWelded:
        return {QUADRILLE_MESSAGE("{from} vertices that the format had split were joined to {to}."), ""};
    case Issue::Code::FileLarge:
        return {QUADRILLE_MESSAGE("The file will take about {size}."), ""};
    case Issue::Code::TexturesBeside:
        return {
            QUADRILLE_MESSAGE("GLB cannot change textures: it shows that of the first frame, and those of "
                              "all frames are beside it, in {path}."),
            ""};
    case Issue::Code::Other:
        return {"{text}", ""};
    }
    return {"", ""};
}

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// What went wrong. Each code has one English sentence and one remedy in `messages.cpp`; the editor
/// translates the same sentences.
enum class ErrorCode
{
    Cancelled,
    // files
    FileNotFound,
    PermissionDenied,
    ReadFailed,
    WriteFailed,
    FileEmpty,
    FileTruncated,
    FileEncoding,
    FileSyntax,
    CountTooLarge,
    // formats
    FormatUnknown,
    FormatRefused,
    FormatNeedsMesh,
    FormatCannotStore,
    // series
    SeriesEmpty,
    SeriesAmbiguous,
    // meshes
    NoVertices,
    NoFaces,
    PolygonSoup,
    SceneWithoutMesh,
    IndexOutOfRange,
    NonFiniteCoordinate,
    VertexCountMismatch,
    TopologyMismatch,
    RangeOutside,
    NoUvs,
    // textures
    ImageUnreadable,
    ImageCountMismatch,
    // project
    ProjectSyntax,
    ProjectInvalid,
    ProjectNewer,
    ProjectMissingMedia,
    ProjectUnknownTarget,
    ProjectUnknownData,
    // results
    ResultDamaged,
    ResultReplaced,
    // use
    BadArgument,
    // the machine, and what nobody foresaw
    OutOfMemory,
    Unexpected,
    // motion
    CharacterTopologyMismatch,
    NoUsableTriangles,
    // transitions
    NoTransition,
    // post-processing of clips
    LoopTooShort,
    LoopCutTooShort,
    TimeCurveNotMonotone,
    NoSymmetry,
    SymmetryMapWrong,
    NoFeet,
    // walks
    WalkKeyOrder,
    WalkKeyUnreachable,
    WalkKeyUntimely,
    WalkFramesMissing,
    WalkActionImpossible,
    WalkPathShort,
    WalkSpanOutside,
    WalkObstacleAtStart,
    WalkPathBlocked,
    WalkDemandUnmet,
    WalkNotFound,
    WalkPathImpassable,
    WalkDemandImpossible,
    WalkImpossible,
    // variations
    TakeTooShort,
    // curves on a surface
    CurveVertexOutside,
    CurveShort,
    CurveOpen,
    CurveMeetsItself,
    CurveMeetsOther,
    CurveDoesNotSeparate,
    CurveNameTaken,
    CurvePointTwice,
    CurvePointTaken,
    CurveNoRoute,
    CurveNoParallel,
    CurveBoundsNothing,
    // parts of a body
    PartNameTaken,
    PartRootMissing,
    PartRootTwice,
    PartParentUnknown,
    PartCycle,
    PartCurveCount,
    PartCurveUnknown,
    PartCurveShared,
    PartCurvesApart,
    PartMisplaced,
    PartEmpty,
    PartsNoLimbs,
    PartsLimbGrown,
    PartsNotCut,
    // variations
    VariationMissing,
    // transfers
    TransferNoPairs,
    TransferTriangleOfTemplate,
    TransferTriangleOfTarget,
    TransferTriangleTwice,
    TransferTriangleFlat,
    TransferNoLimbsOfTemplate,
    TransferNoLimbsOfTarget,
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/file.h"
#include "model/core/message.h"

#include <cerrno>

namespace quadrille {

namespace {

/// What the system's number means to a user; the system's own words are never shown.
std::string reasonOf(int error)
{
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        return QUADRILLE_MESSAGE("the disk is full");
    case EFBIG:
        return QUADRILLE_MESSAGE("the file would be larger than this disk allows");
    case EIO:
    case ENXIO:
    case ENODEV:
        return QUADRILLE_MESSAGE("the disk reports an error");
    case ENOENT:
        return QUADRILLE_MESSAGE("the folder is not there any more");
    case ENOTDIR:
    case EEXIST:
        return QUADRILLE_MESSAGE("a file stands where a folder should be");
    case EISDIR:
        return QUADRILLE_MESSAGE("a folder stands where the file should be");
    case ENOTEMPTY:
        return QUADRILLE_MESSAGE("the folder is not empty");
    case EMFILE:
    case ENFILE:
        return QUADRILLE_MESSAGE("too many files are open");
    case ELOOP:
        return QUADRILLE_MESSAGE("its links lead round in a circle");
    case EBUSY:
    case ETXTBSY:
        return QUADRILLE_MESSAGE("another program is using it");
    case ENOMEM:
        return QUADRILLE_MESSAGE("the system is out of memory");
    case ESTALE:
    case ETIMEDOUT:
    case EHOSTDOWN:
        return QUADRILLE_MESSAGE("the network drive does not answer");
    default:
        return "the system refuses it (error " + std::to_string(error) + ")";
    }
}

} // namespace

void throwSystemError(const std::filesystem::path& path, int error, ErrorCode fallback)
{
    const bool isWriting = fallback == ErrorCode::WriteFailed;
    if ((error == ENOENT || error == ENOTDIR) && !isWriting)
        throw Error(ErrorCode::FileNotFound, {path, {}, {}});
    if (error == EACCES || error == EPERM || error == EROFS)
        throw Error(ErrorCode::PermissionDenied, {path, {}, {}});
    if (error == ENAMETOOLONG)
        throw Error(
            ErrorCode::BadArgument,
            {path,
             {},
             {{"reason", QUADRILLE_MESSAGE("The name of this file, or of a folder on the way to it, is "
                                           "longer than the disk allows")},
              {"remedy", QUADRILLE_MESSAGE("Choose a shorter name.")}}});
    throw Error(fallback, {path, {}, {{"reason", reasonOf(error)}}});
}

} // namespace quadrille

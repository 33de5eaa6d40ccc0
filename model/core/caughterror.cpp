// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/caughterror.h"

#include "model/core/file.h"

#include <cerrno>
#include <new>
#include <stdexcept>
#include <system_error>

namespace quadrille {

namespace {

Error errorOfSystem(const std::filesystem::path& file, const std::error_code& code)
{
    const int number = code.default_error_condition().value();
    const bool isOfWriting = number == ENOSPC || number == EDQUOT || number == EFBIG || number == EROFS;
    try {
        throwSystemError(file, number, isOfWriting ? ErrorCode::WriteFailed : ErrorCode::ReadFailed);
    } catch (const Error& error) {
        return error;
    }
}

Error unexpected(const std::filesystem::path& file, const char* detail)
{
    return Error(ErrorCode::Unexpected, {file, {}, {{"detail", detail}}});
}

} // namespace

Error caughtError(const std::filesystem::path& file)
{
    try {
        throw;
    } catch (const Error& error) {
        return error;
    } catch (const std::bad_alloc&) {
        return Error(ErrorCode::OutOfMemory, {file, {}, {}});
    } catch (const std::length_error&) {
        return Error(ErrorCode::OutOfMemory, {file, {}, {}});
    } catch (const std::filesystem::filesystem_error& error) {
        return errorOfSystem(error.path1().empty() ? file : error.path1(), error.code());
    } catch (const std::system_error& error) {
        return errorOfSystem(file, error.code());
    } catch (const std::exception& error) {
        return unexpected(file, error.what());
    } catch (...) {
        return unexpected(file, "an exception without a name");
    }
}

} // namespace quadrille

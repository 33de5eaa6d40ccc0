// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/caughterror.h"
#include "model/core/file.h"
#include "tests/model/codeof.h"
#include "tests/model/project/testproject.h"

#include <cerrno>
#include <cstring>
#include <gmock/gmock.h>
#include <stdexcept>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::HasSubstr;
using ::testing::Not;

namespace {

std::string whatOfReading(const std::filesystem::path& file)
{
    try {
        readFile(file);
    } catch (const Error& error) {
        EXPECT_EQ(error.context().file, file);
        return error.what();
    }
    return "it was read";
}

std::string whatOfSystem(int number, ErrorCode fallback)
{
    try {
        throwSystemError("/place/take.pc2", number, fallback);
    } catch (const Error& error) {
        return error.what();
    }
}

template <typename Exception>
Error caught(const Exception& exception)
{
    try {
        throw exception;
    } catch (...) {
        return caughtError("take.pc2");
    }
}

} // namespace

TEST(File, OnlyFilesAreOpenedAndNothingIsWaitedFor)
{
    const TemporaryFolder folder;
    const auto pipe = folder / "take.pc2";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(whatOfReading(pipe), HasSubstr("This is a pipe, not a file. Choose a file"));
    EXPECT_THAT(whatOfReading("/dev/zero"), HasSubstr("This is a device, not a file"));
    EXPECT_THAT(whatOfReading(folder.path()), HasSubstr("This is a folder, not a file"));
    const auto link = folder / "link.pc2";
    std::filesystem::create_symlink(pipe, link);
    EXPECT_THAT(whatOfReading(link), HasSubstr("This is a pipe"));
    const auto socket = folder / "s";
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, socket.c_str(), sizeof address.sun_path - 1);
    const int descriptor = ::socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(::bind(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_THAT(whatOfReading(socket), HasSubstr("This is a socket, not a file"));
    ::close(descriptor);
    EXPECT_EQ(codeOf([&] { readFile(folder / "none"); }), ErrorCode::FileNotFound);
    EXPECT_EQ(codeOf([&] { readFile(folder.write("empty", "")); }), ErrorCode::FileEmpty);
}

TEST(File, WhatTheSystemSaysIsSaidInWordsOfOurOwn)
{
    EXPECT_THAT(whatOfSystem(ENOSPC, ErrorCode::WriteFailed), HasSubstr("the disk is full"));
    EXPECT_THAT(whatOfSystem(ENAMETOOLONG, ErrorCode::WriteFailed), HasSubstr("Choose a shorter name"));
    EXPECT_THAT(whatOfSystem(EMFILE, ErrorCode::ReadFailed), HasSubstr("too many files are open"));
    for (int number = 1; number < 134; ++number) {
        for (const ErrorCode code : {ErrorCode::ReadFailed, ErrorCode::WriteFailed})
            EXPECT_THAT(whatOfSystem(number, code), Not(HasSubstr(std::strerror(number)))) << number;
    }
}

TEST(File, WhatALibraryThrowsIsNeverSaidAlone)
{
    EXPECT_EQ(caught(std::bad_alloc()).code(), ErrorCode::OutOfMemory);
    EXPECT_EQ(caught(std::length_error("vector::_M_default_append")).code(), ErrorCode::OutOfMemory);
    const Error system = caught(std::filesystem::filesystem_error(
        "cannot make folder", "/place/out", std::make_error_code(std::errc::no_space_on_device)));
    EXPECT_STREQ(system.what(), "/place/out: Writing failed: the disk is full. Check free space and "
                                "permissions, then try again.");
    const Error other = caught(std::out_of_range("map::at"));
    EXPECT_EQ(other.code(), ErrorCode::Unexpected);
    EXPECT_THAT(other.what(),
                HasSubstr("take.pc2: Something unexpected happened inside the program (map::at)"));
    EXPECT_EQ(caught(Error(ErrorCode::NoFaces)).code(), ErrorCode::NoFaces);
}

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Linked into the editor and the tests of the interface under sanitizers: graphics drivers stay loaded until
// the leak sanitizer has looked, so that it knows the names by which tests/lsan.supp tells their leaks from
// ours.
extern "C" int dlclose(void* /*library*/)
{
    return 0;
}

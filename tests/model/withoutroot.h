// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <unistd.h>

namespace quadrille {

/// Gives up the rights of root for a while: root may read everything.
class WithoutRoot
{
public:
    WithoutRoot() : m_wasRoot(::geteuid() == 0) { m_isPlain = !m_wasRoot || ::seteuid(nobody) == 0; }
    ~WithoutRoot()
    {
        if (m_wasRoot && m_isPlain && ::seteuid(0) != 0)
            std::abort();
    }
    WithoutRoot(const WithoutRoot&) = delete;
    WithoutRoot& operator=(const WithoutRoot&) = delete;
    bool isPlain() const { return m_isPlain; }
    bool wasRoot() const { return m_wasRoot; }

private:
    static constexpr uid_t nobody = 65534;
    bool m_wasRoot;
    bool m_isPlain = false;
};

} // namespace quadrille

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/qt/registry.h"
#include "widgets/viewport/vtkview.h"

namespace quadrille::test {

/// An application whose views draw as those of the program do, without a window around them.
class ViewApplication : public QApplication
{
public:
    ViewApplication(int& argc, char** argv) : QApplication((widgets::VtkView::setDefaultFormat(), argc), argv)
    {
    }
};

} // namespace quadrille::test

// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QComboBox;

namespace quadrille {

class CurrentTransfer;

namespace widgets {
class LineChart;
}

/// How each frame of a transfer came out, with the frame that is shown: its marker plays along, and goes
/// there when it is dragged.
class TransferChart : public QWidget
{
    Q_OBJECT

public:
    explicit TransferChart(CurrentTransfer& transfer, QWidget* parent = nullptr);

private:
    void retranslate();
    void refresh();
    void showFrame();

    CurrentTransfer& m_transfer;
    QComboBox* m_what;
    widgets::LineChart* m_chart;
};

} // namespace quadrille

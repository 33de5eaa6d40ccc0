// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <vector>

class QCheckBox;
class QFormLayout;
class QLabel;
class QSlider;

namespace quadrille {

class Gamepad;
class LiveSession;
class SpaceGraph;
class SpaceMap;

/// The spaces that can be played as a graph, in which a click wants one; sliders for the parameters of the
/// one that is wanted, in their units; and what is played.
class SteeringPanel : public QWidget
{
    Q_OBJECT

public:
    /// Refers to session and gamepad. \param graph  becomes the panel's.
    SteeringPanel(SpaceGraph& graph, LiveSession& session, const Gamepad& gamepad, QWidget* parent = nullptr);

    /// Milliseconds that the last picture took, for the readout.
    void setPictureTime(double milliseconds) { m_pictureMilliseconds = milliseconds; }

private:
    struct Row
    {
        QLabel* name;
        QSlider* slider;
        QLabel* value;
    };

    void makeRows();
    void retranslate();
    void showParameters();
    QString keysText() const;
    void showValues();
    void showReadout();

    LiveSession& m_session;
    const Gamepad& m_gamepad;
    SpaceMap* m_map;
    QFormLayout* m_form;
    std::vector<Row> m_rows;
    QCheckBox* m_responsive;
    QLabel* m_keys;
    QLabel* m_readout;
    QLabel* m_gamepadText;
    double m_pictureMilliseconds = 0;
};

} // namespace quadrille

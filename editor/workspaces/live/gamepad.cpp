// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/live/gamepad.h"

#include <QElapsedTimer>
#include <SDL2/SDL.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace quadrille {

namespace {

constexpr double deadZone = 0.18; ///< of a stick's way
constexpr qint64 millisecondsBetweenSearches = 500;

constexpr std::array watchedButtons{SDL_CONTROLLER_BUTTON_A, SDL_CONTROLLER_BUTTON_LEFTSHOULDER,
                                    SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, SDL_CONTROLLER_BUTTON_START};

/// −1 … 1, nothing within the dead zone and all of the rest beyond it.
double deflectionOf(SDL_GameController* controller, SDL_GameControllerAxis axis)
{
    constexpr double full = 32767;
    const double value = std::clamp(SDL_GameControllerGetAxis(controller, axis) / full, -1.0, 1.0);
    const double beyond = std::max(std::abs(value) - deadZone, 0.0) / (1 - deadZone);
    return std::copysign(beyond, value) + 0.0; // no negative zero
}

} // namespace

struct Gamepad::Private
{
    bool isReady = false;
    QElapsedTimer lastSearch;
    SDL_GameController* controller = nullptr;
    std::array<bool, watchedButtons.size()> isDown{};
};

Gamepad::Gamepad(QObject* parent) : QObject(parent), d(std::make_unique<Private>())
{
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1"); // SDL has no window of its own here
    d->isReady = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
}

Gamepad::~Gamepad()
{
    if (d->controller != nullptr)
        SDL_GameControllerClose(d->controller);
    if (d->isReady)
        SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

bool Gamepad::isConnected() const
{
    return d->controller != nullptr;
}

QString Gamepad::name() const
{
    const char* name = d->controller == nullptr ? nullptr : SDL_GameControllerName(d->controller);
    return name == nullptr ? QString() : QString::fromUtf8(name);
}

void Gamepad::connectFirst()
{
    if (d->lastSearch.isValid() && d->lastSearch.elapsed() < millisecondsBetweenSearches)
        return;
    d->lastSearch.start();
    for (int each = 0; each < SDL_NumJoysticks() && d->controller == nullptr; ++each) {
        if (SDL_IsGameController(each) == SDL_TRUE)
            d->controller = SDL_GameControllerOpen(each);
    }
    if (d->controller != nullptr)
        emit connectedChanged();
}

void Gamepad::press(int button)
{
    switch (button) {
    case SDL_CONTROLLER_BUTTON_A:
        emit jumpPressed();
        break;
    case SDL_CONTROLLER_BUTTON_LEFTSHOULDER:
        emit spacePressed(-1);
        break;
    case SDL_CONTROLLER_BUTTON_RIGHTSHOULDER:
        emit spacePressed(1);
        break;
    default:
        emit recordPressed();
        break;
    }
}

void Gamepad::poll()
{
    if (!d->isReady)
        return;
    SDL_GameControllerUpdate();
    if (d->controller != nullptr && SDL_GameControllerGetAttached(d->controller) != SDL_TRUE) {
        SDL_GameControllerClose(d->controller);
        d->controller = nullptr;
        d->isDown = {};
        m_state = {};
        emit connectedChanged();
    }
    if (d->controller == nullptr)
        connectFirst();
    if (d->controller == nullptr)
        return;
    m_state.axes = {deflectionOf(d->controller, SDL_CONTROLLER_AXIS_LEFTX),
                    -deflectionOf(d->controller, SDL_CONTROLLER_AXIS_LEFTY) + 0.0,
                    -deflectionOf(d->controller, SDL_CONTROLLER_AXIS_RIGHTY) + 0.0};
    m_state.isAnalog = !m_state.isIdle();
    for (std::size_t each = 0; each < watchedButtons.size(); ++each) {
        const bool isDown = SDL_GameControllerGetButton(d->controller, watchedButtons.at(each)) != 0;
        const bool wasDown = std::exchange(d->isDown.at(each), isDown);
        if (isDown && !wasDown)
            press(watchedButtons.at(each));
    }
}

} // namespace quadrille

#include "moc_gamepad.cpp"

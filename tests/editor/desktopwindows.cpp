// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "desktopwindows.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <memory>
#include <span>

namespace quadrille::test {

namespace {

/// Windows come and go while they are looked at: what is asked of one that is gone has no answer.
int ignoreError(Display* /*display*/, XErrorEvent* /*event*/)
{
    return 0;
}

Display& display()
{
    static Display* opened = [] {
        XSetErrorHandler(ignoreError);
        return XOpenDisplay(nullptr);
    }();
    return *opened;
}

Atom atom(const char* name)
{
    return XInternAtom(&display(), name, False);
}

struct Property
{
    std::unique_ptr<unsigned char, int (*)(void*)> bytes{nullptr, XFree};
    std::size_t count = 0;

    /// Of 32-bit properties, which Xlib hands out as longs.
    std::span<const unsigned long> numbers() const
    {
        return {reinterpret_cast<const unsigned long*>(bytes.get()), bytes ? count : 0};
    }
};

Property propertyOf(Window window, const char* name)
{
    Atom type = 0;
    int format = 0;
    unsigned long count = 0;
    unsigned long rest = 0;
    unsigned char* bytes = nullptr;
    XGetWindowProperty(&display(), window, atom(name), 0, 1 << 16, False, AnyPropertyType, &type, &format,
                       &count, &rest, &bytes);
    Property property;
    property.bytes.reset(bytes);
    property.count = count;
    return property;
}

void send(Window window, const char* message, long first, long second = 0, long third = 0)
{
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    event.xclient.data.l[0] = first;
    event.xclient.data.l[1] = second;
    event.xclient.data.l[2] = third;
    XSendEvent(&display(), DefaultRootWindow(&display()), False,
               SubstructureRedirectMask | SubstructureNotifyMask, &event);
    XFlush(&display());
}

} // namespace

std::vector<DesktopWindow> windowsOf(qint64 processId)
{
    std::vector<DesktopWindow> windows;
    const Property clients = propertyOf(DefaultRootWindow(&display()), "_NET_CLIENT_LIST");
    for (const unsigned long id : clients.numbers()) {
        const Property owner = propertyOf(id, "_NET_WM_PID");
        if (owner.numbers().empty() || owner.numbers().front() != static_cast<unsigned long>(processId))
            continue;
        const Property title = propertyOf(id, "_NET_WM_NAME");
        windows.push_back({id, QString::fromUtf8(reinterpret_cast<const char*>(title.bytes.get()),
                                                 static_cast<qsizetype>(title.count))});
    }
    return windows;
}

void ask(WindowWish wish, const DesktopWindow& window)
{
    constexpr long add = 1;
    switch (wish) {
    case WindowWish::Maximise:
        send(window.id, "_NET_WM_STATE", add, static_cast<long>(atom("_NET_WM_STATE_MAXIMIZED_HORZ")),
             static_cast<long>(atom("_NET_WM_STATE_MAXIMIZED_VERT")));
        break;
    case WindowWish::FillScreen:
        send(window.id, "_NET_WM_STATE", add, static_cast<long>(atom("_NET_WM_STATE_FULLSCREEN")));
        break;
    case WindowWish::Close:
        send(window.id, "_NET_CLOSE_WINDOW", 0);
        break;
    }
}

QSize sizeOf(const DesktopWindow& window)
{
    XWindowAttributes attributes{};
    if (XGetWindowAttributes(&display(), window.id, &attributes) == 0)
        return {};
    return {attributes.width, attributes.height};
}

} // namespace quadrille::test

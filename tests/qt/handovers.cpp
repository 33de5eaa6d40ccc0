// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT

// Qt is not instrumented: that it hands a function over from one thread to another is invisible to the thread
// sanitizer, which would report all that the function touches. Here it is told of each: what was done before
// a function was handed over comes before all that is delivered later.
#include "tests/qt/handovers.h"

#include <QThreadPool>
#include <dlfcn.h>
#include <sanitizer/tsan_interface.h>
#include <tbb/global_control.h>

namespace {

// Nor is TBB: loops run on the thread that asks for them. Parallel, they would keep the sanitizer busy with
// races that are none; the tests of the model look at them in programs that do little else.
const tbb::global_control oneThreadEach(tbb::global_control::max_allowed_parallelism, 1);

char handovers; // its address is what the sanitizer keeps in order

template <typename Function>
Function realOne(const char* symbol)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, symbol));
}

} // namespace

void quadrille::test::takeHandovers()
{
    __tsan_acquire(&handovers);
}

bool QMetaObject::invokeMethodImpl(QObject* object, QtPrivate::QSlotObjectBase* slot, Qt::ConnectionType type,
                                   void* result)
{
    static const auto real = realOne<bool (*)(QObject*, QtPrivate::QSlotObjectBase*, Qt::ConnectionType,
                                              void*)>(
        "_ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv");
    __tsan_release(&handovers);
    return real(object, slot, type, result);
}

void QThreadPool::start(std::function<void()> function, int priority)
{
    static const auto real = realOne<void (*)(QThreadPool*, std::function<void()>, int)>(
        "_ZN11QThreadPool5startESt8functionIFvvEEi");
    std::function<void()> told = [function = std::move(function)] {
        __tsan_acquire(&handovers);
        function();
        __tsan_release(&handovers);
    };
    __tsan_release(&handovers);
    real(this, std::move(told), priority);
}

bool QThreadPool::waitForDone(int milliseconds)
{
    static const auto real = realOne<bool (*)(QThreadPool*, int)>("_ZN11QThreadPool11waitForDoneEi");
    const bool isDone = real(this, milliseconds);
    __tsan_acquire(&handovers);
    return isDone;
}

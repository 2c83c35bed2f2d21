#include "app/interrupt.h"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <initializer_list>

namespace cydonia {
namespace {

// Written by the signal handler and read by every thread that reports progress.
std::atomic<int> g_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not lock");

void remember(int signal) { g_signal = signal; }

}  // namespace

void catch_interrupts() {
    for (int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        struct sigaction action = {};
        action.sa_handler = remember;
        // After the first Ctrl-C the next one has its usual effect. SIGPIPE comes with
        // every line that we try to write, so it stays caught.
        action.sa_flags = SA_RESTART;
        if (signal != SIGPIPE) action.sa_flags |= static_cast<int>(SA_RESETHAND);
        // A signal that the caller ignores (nohup) stays ignored.
        struct sigaction before = {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
}

int interrupt_signal() { return g_signal; }

void end_by(int signal) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    std::_Exit(128 + signal);
}

}  // namespace cydonia

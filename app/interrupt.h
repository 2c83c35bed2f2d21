#pragma once

namespace cydonia {

// From now on Ctrl-C (SIGINT), SIGTERM, SIGHUP and a reader that went away (SIGPIPE) only
// raise a flag, which progress reports turn into Interrupted: everything unwinds,
// children are ended and temporary files removed. A second Ctrl-C ends the program at
// once.
void catch_interrupts();

// The signal that asked the program to stop, 0 when none did.
int interrupt_signal();

// Ends the process by that signal, as the shell that started it expects.
[[noreturn]] void end_by(int signal);

}  // namespace cydonia

#pragma once

namespace cydonia {

// From now on Ctrl-C (SIGINT), SIGTERM, SIGHUP and a closed pipe (SIGPIPE) only set a
// flag. The next progress report then throws Interrupted: the stack unwinds, child
// processes are ended and temporary files removed. A second Ctrl-C ends the program at
// once.
void catch_interrupts();

// The signal that asked the program to stop; 0 if none did.
int interrupt_signal();

// Ends the process by that signal, so that the shell sees why it ended.
[[noreturn]] void end_by(int signal);

}  // namespace cydonia

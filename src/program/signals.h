// Signals that ask the program to stop, and streams that must not fail in silence.
#pragma once

namespace furrow {

// From now on SIGINT, SIGTERM and SIGHUP are noted in interrupt_request, and whatever is at work closes its files and
// ends. A second one ends the program at once. If the first has not ended it after most of a second, the program ends
// as soon as no file is being written. A SIGHUP that is ignored, as by nohup, stays so. A write beyond the limit of
// file sizes or into a closed pipe fails and is reported, instead of SIGXFSZ or SIGPIPE ending the program.
void watch_signals();

// Standard streams that are closed are opened such that no file takes their place: what goes to standard output fails.
void guard_standard_streams();

// Throws FileError if not all of what was printed to standard output has arrived there.
void flush_standard_output();

}  // namespace furrow

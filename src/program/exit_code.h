#pragma once

namespace furrow {

enum ExitCode { good = 0, check_failed = 1, bad_input = 2, diverged = 3, io_failed = 4, interrupted = 130 };

}  // namespace furrow

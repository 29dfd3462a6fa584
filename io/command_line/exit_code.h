// Exit codes of the programs; docs/engineer/clients.md and `coapt --help` list them.
#pragma once

namespace coapt::exit_code {

inline constexpr int kOk = 0;
inline constexpr int kFailure = 1;    ///< the program failed: an output could not be written
inline constexpr int kBadInput = 2;   ///< the command line or an input file is wrong
inline constexpr int kNotClosed = 3;  ///< the closure did not converge, or leaflets cross
inline constexpr int kUnchecked =
    3;  ///< with --strict: an import decided what a person should check
inline constexpr int kNoRobustPlan = 4;  ///< the best plan is not known to close the valve robustly
inline constexpr int kInterrupted = 130;  ///< Ctrl-C; the best so far was printed

}  // namespace coapt::exit_code

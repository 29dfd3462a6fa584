// The commands of coapt-farm, one file each.
#pragma once

#include <string>

#include "farm/database/compute_thread.h"
#include "io/command_line/command_line.h"

namespace coapt {

/// What a program of a farm can compute: its kinds of work, and which workers may answer for it.
struct FarmKinds {
  WorkOpener open;
  std::string revision;
};

/// Each adds one command to `parent`; a command that is chosen runs while the line is parsed, and leaves its exit code in
/// `status`.
void add_init(Command parent, int& status);
void add_add(Command parent, int& status, const FarmKinds& kinds);
void add_work(Command parent, int& status, const FarmKinds& kinds);
void add_status(Command parent, int& status);
void add_fetch(Command parent, int& status, const FarmKinds& kinds);
void add_cancel(Command parent, int& status);
void add_forget(Command parent, int& status);

/// All of them.
void add_farm_commands(Command app, int& status, const FarmKinds& kinds);

/// Help of the program as a whole: examples and exit codes.
extern const char* const kFarmFooter;
inline constexpr const char* kFarmDescription =
    "Distributes the closures and searches of coapt over any number of machines through a "
    "database.";

}  // namespace coapt

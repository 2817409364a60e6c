#pragma once

#include <sys/types.h>
#include <string>

namespace ew {

/// Eight hexadecimal digits that stand for where numbers of processes mean something: this machine, as it was started last, and in a
/// container this one. In a folder that others share, the number of a process says nothing without it. Two machines of one name, or two
/// containers of one machine, have different marks.
[[nodiscard]] const std::string& machineMark();

/// Whether a process of this number is there, also one of which the system tells us nothing else (another account's, with hidepid).
[[nodiscard]] bool isProcessThere(pid_t process);

}  // namespace ew

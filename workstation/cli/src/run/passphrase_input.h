#pragma once

#include <string>

#include "ew/core/result.h"
#include "ew/library/passphrase.h"

namespace ew::cli {

/// How the help calls it.
inline constexpr const char* kPassphraseSource = "ask|fd:N|FILE";

/// Reads a passphrase from where somebody says it is: "ask" (the terminal, which does not show it), "fd:N" (the first line of an open file
/// descriptor) or a file that only its owner reads. Never from the command line itself, which every account of the machine can read.
/// @param prompt what the terminal asks
/// @error badUsage (no terminal, no such descriptor, nothing there), as readPrivateFile
[[nodiscard]] Result<Passphrase> readPassphrase(const std::string& source, const Message& prompt);

/// The same for a new one: on a terminal it is asked for twice. @error also checkNewPassphrase
[[nodiscard]] Result<Passphrase> readNewPassphrase(const std::string& source, const Message& prompt);

}  // namespace ew::cli

#pragma once

#include <string>

#include "ew/core/result.h"

namespace ew::cli {

/// The option that answers what an error asks for (askedFor), or empty.
[[nodiscard]] std::string optionFor(const std::string& asked);

/// An error whose sentence ends with the option that answers what is missing, where its context says so ("ask").
[[nodiscard]] tl::unexpected<Error> withOption(Error error);

}  // namespace ew::cli

#pragma once

#include "ew/core/result.h"

namespace ew::cli {

/// An error whose sentence ends with the option that answers what is missing, where its context says so ("ask").
[[nodiscard]] tl::unexpected<Error> withOption(Error error);

}  // namespace ew::cli

#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "ew/imaging/probe.h"
#include "places.h"

namespace ew::testing {

inline Probe shippedProbe(const std::string& id) {
  auto probe = readProbe(std::filesystem::path(EW_SOURCE_DIR) / "resources/probes" / (id + ".json"));
  if (!probe) {
    ADD_FAILURE() << probe.error();
    std::abort();
  }
  return *probe;
}

}  // namespace ew::testing

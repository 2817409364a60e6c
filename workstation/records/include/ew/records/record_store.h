#pragma once

#include <string>

#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// A learning record store (xAPI 1.0.3) and how this program is let in.
struct RecordStore {
  std::string endpoint;       ///< "https://records.example/xapi/": "statements" is asked for below it
  std::string authorization;  ///< the whole header: basicAuthorization(), bearerAuthorization(), or what a launch gave
  bool allowsHttp = false;    ///< also to other machines, where everybody on the way can read it
  std::string certificates;   ///< PEM file of the authorities that are trusted; empty: the system's
  double connect_s = 15.0;    ///< until a connection stands, > 0
  double timeout_s = 60.0;    ///< for a whole question and its answer, > 0
};

/// RFC 7617. @error badField (the user holds a colon; controls)
[[nodiscard]] Result<std::string> basicAuthorization(const std::string& user, const std::string& secret);
/// RFC 6750. @error badField (empty, or letters no token has)
[[nodiscard]] Result<std::string> bearerAuthorization(const std::string& token);

/// Asks for one statement: whether there is a record store that lets us in. @error badField (endpoint), notReadable (no, and why),
/// cancelled
[[nodiscard]] Result<void> askRecordStore(const RecordStore& store, const Progress& progress = noProgress());

}  // namespace ew

#include "run/length_option.h"

#include <algorithm>

#include "ew/core/numbers.h"

namespace ew::cli {

Result<std::vector<double>> lengthsGiven(const std::string& option, const std::string& text, std::size_t count) {
  std::string spaced = text;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  auto values = parseNumbers(spaced);
  if (values && values->size() == 1) values->resize(count, values->front());
  if (!values || values->size() != count ||
      !std::all_of(values->begin(), values->end(), [](double value) { return value > 0.0 && value < 1e6; }))
    return failure(ErrorCode::badUsage,
                   say<"%1 takes one length or %2 with commas between them, in mm, above 0; not '%3'.">(option, count, text));
  return *values;
}

}  // namespace ew::cli

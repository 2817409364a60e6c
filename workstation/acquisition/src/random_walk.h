#pragma once

#include <memory>

#include "ew/core/image.h"

namespace ew {

/// Solves for the probability that a random walker reaches the first row of an image before the last one.
class RandomWalk {
 public:
  RandomWalk();
  ~RandomWalk();

  struct Weights {
    double alpha = 0.0;
    double beta = 0.0;
    double gamma = 0.0;
  };
  /// @param levels      (rows x columns), 0..1; at least 3 rows and 2 columns
  /// @param probability resized alike; 1 in the first row, 0 in the last
  /// @return false when the equations could not be solved
  [[nodiscard]] bool solve(const Image<float>& levels, const Weights& weights, Image<float>& probability);

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace ew

#include "ew/core/frames.h"

#include <cmath>
#include <ostream>
#include <sstream>

namespace ew {

glm::dmat4 matrixFromRows(const std::array<double, 16>& rowMajor) {
  glm::dmat4 matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix[column][row] = rowMajor[static_cast<std::size_t>(4 * row + column)];
  return matrix;
}

std::array<double, 16> rowsOf(const glm::dmat4& matrix) {
  std::array<double, 16> rows{};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) rows[static_cast<std::size_t>(4 * row + column)] = matrix[column][row];
  return rows;
}

Result<void> checkRigid(const glm::dmat4& matrix, double tolerance) {
  const auto refuse = [](Message why) {
    return failure(
        ErrorCode::notRigid,
        say<"The pose is not a rotation with a translation: %1. Give 16 numbers, row by row, with orthonormal axes and a last row "
            "of 0 0 0 1.">(std::move(why)));
  };
  for (const double value : rowsOf(matrix))
    if (!std::isfinite(value)) return refuse(say<"one of its numbers is not finite">());
  for (int column = 0; column < 4; ++column)
    if (std::abs(matrix[column][3] - (column == 3 ? 1.0 : 0.0)) > tolerance) return refuse(say<"its last row is not 0 0 0 1">());
  const std::string names[] = {"x", "y", "z"};
  for (int a = 0; a < 3; ++a) {
    const double length = glm::length(glm::dvec3(matrix[a]));
    if (std::abs(length - 1.0) > tolerance) {
      std::ostringstream text;
      text << length;
      return refuse(say<"its %1 axis has length %2 instead of 1">(names[a], text.str()));
    }
    for (int b = a + 1; b < 3; ++b)
      if (std::abs(glm::dot(glm::dvec3(matrix[a]), glm::dvec3(matrix[b]))) > tolerance)
        return refuse(say<"its %1 and %2 axes are not orthogonal">(names[a], names[b]));
  }
  if (glm::determinant(glm::dmat3(matrix)) < 0.0) return refuse(say<"it is mirrored (left-handed)">());
  return {};
}

std::ostream& printMatrix(std::ostream& out, const glm::dmat4& matrix) {
  const auto rows = rowsOf(matrix);
  for (std::size_t i = 0; i < rows.size(); ++i) out << (i == 0 ? "" : i % 4 == 0 ? "; " : " ") << rows[i];
  return out;
}

}  // namespace ew

#pragma once

#include <chrono>
#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/result.h"

namespace ew {

inline constexpr int kCommentsFormat = 1;  ///< `format` of a file of comments; a larger one is refused with newerFormat

/// Something drawn on an image, in mm of the probe's image plane (lateral, axial), so that it lies on the same tissue in an image of any
/// size, zoomed or mirrored.
struct CommentStroke {
  enum class Kind {
    line,   ///< along its points, two or more
    arrow,  ///< from its first point to its second, which it points at
    circle  ///< about its first point, through its second
  };
  Kind kind = Kind::line;
  std::vector<glm::dvec2> points_mm;
  bool operator==(const CommentStroke&) const = default;
};

/// What a reviewer says about a moment of a step's scan.
struct ReviewComment {
  std::string id;         ///< unique in its file
  std::string stepId;     ///< of the attempt
  std::string recording;  ///< of the step, relative to the attempt's folder: a step that was repeated has several
  double time_s = 0.0;    ///< on the recording's own clock
  std::string text;       ///< may be empty where something is drawn
  std::vector<CommentStroke> strokes;
  std::optional<Transform<frame::World, frame::Probe>> probeToWorld;  ///< where the probe was; empty: nobody knew
  std::chrono::sys_seconds at{};                                      ///< when it was written
  nlohmann::json otherFields = nlohmann::json::object();
  bool operator==(const ReviewComment&) const = default;
};

/// One author's comments on one attempt.
struct CommentFile {
  std::string author;  ///< as they call themselves; may be empty
  std::vector<ReviewComment> comments;
  nlohmann::json otherFields = nlohmann::json::object();
  bool operator==(const CommentFile&) const = default;
};

/// @error badField (field, value found, value expected), newerFormat (with both format numbers)
[[nodiscard]] Result<CommentFile> commentsFromJson(const nlohmann::json& document);
/// commentsFromJson(jsonOf(f)) == f.
[[nodiscard]] nlohmann::json jsonOf(const CommentFile& file);

/// Where an author's comments on an attempt are: ATTEMPT/comments/AUTHOR.json. Authors with different names never share a file.
/// @param attempt folder of the attempt
[[nodiscard]] std::filesystem::path commentsFileOf(const std::filesystem::path& attempt, const std::string& author);

/// The author's own; empty where there are none yet. @error notReadable, badHeader, badField, newerFormat
[[nodiscard]] Result<CommentFile> readComments(const std::filesystem::path& attempt, const std::string& author);
/// Written whole or not at all; a file that a newer program wrote, or that cannot be read, is not written over.
/// @error notWritable, as readComments
[[nodiscard]] Result<void> writeComments(const std::filesystem::path& attempt, const CommentFile& file);

struct CommentList {
  std::vector<CommentFile> files;  ///< by author
  std::vector<Error> problems;     ///< of files that cannot be read, each with its name
};
/// Those of all authors. An attempt without any has none.
[[nodiscard]] CommentList listComments(const std::filesystem::path& attempt);

}  // namespace ew

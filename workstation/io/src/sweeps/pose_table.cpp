#include "ew/io/pose_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
#include <string_view>

#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "files/image_header.h"
#include "sweeps/transform_name.h"
#include "sweeps/usable_transform.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<const char*, 4> kTurn{"qw", "qx", "qy", "qz"};
constexpr std::array<const char*, 3> kPlace{"x", "y", "z"};
constexpr std::array<const char*, 9> kRotation{"m00", "m01", "m02", "m10", "m11", "m12", "m20", "m21", "m22"};
constexpr std::array<const char*, 3> kShift{"m03", "m13", "m23"};
constexpr std::array<const char*, 4> kLastRow{"m30", "m31", "m32", "m33"};

/// A line of the file that is neither blank nor a remark.
struct TableLine {
  std::size_t number = 0;  ///< as an editor counts
  std::string_view text;
};

/// A column by its place, and what turns its numbers into s or mm.
struct Column {
  std::size_t at = 0;
  double scale = 1.0;
};

/// Where each thing stands in a line.
struct TableColumns {
  std::size_t count = 0;
  Column time;
  std::vector<Column> place;     ///< x, y, z, or the last column of the matrix
  std::vector<Column> rotation;  ///< four of the quaternion, or nine of the matrix
  std::vector<Column> lastRow;   ///< none, or four
  std::optional<std::size_t> status;
  [[nodiscard]] bool isMatrix() const { return rotation.size() == kRotation.size(); }
};

std::vector<std::string> cellsOf(std::string_view line, char separator) {
  std::vector<std::string> cells;
  for (std::size_t from = 0;;) {
    const auto end = line.find(separator, from);
    std::string_view cell = trimmed(line.substr(from, end == std::string_view::npos ? end : end - from));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    cells.emplace_back(cell);
    if (end == std::string_view::npos) return cells;
    from = end + 1;
  }
}

std::string listOf(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Empty: the word says nothing that is known.
std::optional<PoseStatus> statusOfWord(std::string_view word) {
  const std::string known = lowerCase(word);
  if (known == "ok") return PoseStatus::ok;
  if (known == "invalid") return PoseStatus::invalid;
  if (known == "missing") return PoseStatus::missing;
  return std::nullopt;
}

/// What a table needs, for sentences.
Message needs() {
  return say<
      "a line of column names with time_s and either x_mm, y_mm, z_mm, qw, qx, qy, qz or the matrix m00 to m22 with m03_mm, m13_mm, "
      "m23_mm">();
}

class TableReader {
 public:
  explicit TableReader(const fs::path& file) : file_(file) {}

  Result<Sequence> read() {
    const auto text = readTextFile(file_);
    if (!text) return passOn(text.error());
    if (auto plain = checkPlain(*text); !plain) return passOn(plain.error());
    if (auto taken = takeLines(*text); !taken) return passOn(taken.error());
    if (lines_.empty())
      return trimmed(*text).empty() ? refuse(say<"%1 is empty; it needs %2.">(quoted(file_), needs()))
                                    : refuse(say<"%1 is empty but for remarks; it needs %2.">(quoted(file_), needs()));
    const std::string_view header = lines_.front().text;
    if (header.find_first_of(";\t,") == std::string_view::npos && wordsOf(header).size() > 1)
      return refuse(say<"In %1 blanks stand between the columns; put commas, semicolons or tabs there.">(quoted(file_)));
    separator_ = header.find(';') != std::string_view::npos ? ';' : header.find('\t') != std::string_view::npos ? '\t' : ',';
    if (auto named = takeHeader(cellsOf(header, separator_)); !named) return passOn(named.error());
    if (lines_.size() < 2) return refuse(say<"%1 names its columns and holds no pose; export the tracking again.">(quoted(file_)));
    sequence_.frames.reserve(lines_.size() - 1);
    for (std::size_t n = 1; n < lines_.size(); ++n)
      if (auto taken = takeLine(lines_[n]); !taken) return passOn(taken.error());
    return std::move(sequence_);
  }

 private:
  [[nodiscard]] tl::unexpected<Error> refuse(Message sentence) const {
    return failure(ErrorCode::badHeader, std::move(sentence), {{"file", file_.string()}});
  }
  [[nodiscard]] tl::unexpected<Error> badLine(std::size_t number, const Message& problem) const {
    return failure(ErrorCode::badField,
                   say<"In line %1 of %2, %3; correct the line, or export the tracking again.">(number, quoted(file_), problem),
                   {{"file", file_.string()}, {"line", std::to_string(number)}});
  }

  [[nodiscard]] Result<void> checkPlain(std::string_view text) const {
    const bool isUtf16 = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
    if (!isUtf16 && text.find('\0') == std::string_view::npos) return {};
    return isUtf16 ? refuse(say<"%1 is text in UTF-16, which is not read; save it as UTF-8.">(quoted(file_)))
                   : refuse(say<"%1 is no text in UTF-8, it holds bytes of 0; save it as UTF-8.">(quoted(file_)));
  }

  Result<void> takeLines(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
    const char lineEnd = text.find('\n') == std::string_view::npos ? '\r' : '\n';  // old programs write CR alone
    std::size_t number = 0;
    for (std::size_t from = 0; from < text.size();) {
      const auto end = std::min(text.find(lineEnd, from), text.size());
      const std::string_view line = text.substr(from, end - from), words = trimmed(line);
      from = end + 1;
      ++number;
      if (words.starts_with('#')) {
        if (auto taken = takeRemark(number, trimmed(words.substr(1))); !taken) return taken;
      } else if (!words.empty()) {
        lines_.push_back({number, line});  // with blanks at its end: of tabs they are columns
      }
    }
    return {};
  }

  Result<void> takeRemark(std::size_t number, std::string_view remark) {
    constexpr std::string_view kTransform = "transform:";
    if (!lowerCase(remark).starts_with(kTransform)) return {};
    const std::string_view name = trimmed(remark.substr(kTransform.size()));
    const auto split = splitTransformName(name);
    if (!split)
      return badLine(number,
                     say<"the transform is \"%1\", and not two names that To joins, as in ProbeToTracker">(shortened(std::string(name))));
    if (lineOfTransform_ > 0 && (split->from != from_ || split->to != to_))
      return badLine(number, say<"the transform is %1, but line %2 says %3To%4">(shortened(std::string(name)), lineOfTransform_,
                                                                                 shortened(from_), shortened(to_)));
    from_ = split->from;
    to_ = split->to;
    lineOfTransform_ = number;
    return {};
  }

  /// A column of this name, or of this name with a unit. Empty: there is none.
  std::optional<Column> find(const std::string& name, std::initializer_list<std::pair<const char*, double>> units = {{"", 1.0}}) {
    std::optional<Column> found;
    for (const auto& [unit, scale] : units)
      for (std::size_t n = 0; n < names_.size(); ++n) {
        if (names_[n] != name + unit) continue;
        isUsed_[n] = true;
        if (found)
          sequence_.notes.push_back(
              say<"The column %1 of %2 is not used, because %3 says it.">(names_[n], quoted(file_), names_[found->at]));
        else
          found = Column{n, scale};
      }
    return found;
  }

  /// All columns of a group; those that are not there are added to `missing` under the name that is wanted.
  template <std::size_t N>
  std::vector<Column> findAll(const std::array<const char*, N>& wanted, bool isLength, std::vector<std::string>& missing) {
    std::vector<Column> columns;
    for (const char* name : wanted) {
      const auto found = isLength ? find(name, {{"_mm", 1.0}, {"_m", 1000.0}}) : find(name);
      if (found)
        columns.push_back(*found);
      else
        missing.push_back(std::string(name) + (isLength ? "_mm" : ""));
    }
    return columns;
  }

  Result<void> takeHeader(std::vector<std::string> cells) {
    if (std::all_of(cells.begin(), cells.end(), [](const std::string& cell) { return parseNumber(cell).has_value(); }))
      return refuse(say<"%1 has no header line, its first line is \"%2\"; it needs %3.">(
          quoted(file_), shortened(std::string(trimmed(lines_.front().text))), needs()));
    for (std::string& cell : cells) cell = lowerCase(cell);
    names_ = std::move(cells);
    isUsed_.assign(names_.size(), false);
    columns_.count = names_.size();
    for (std::size_t n = 0; n < names_.size(); ++n)
      if (!names_[n].empty() && std::count(names_.begin(), names_.end(), names_[n]) > 1)
        return refuse(say<"%1 has the column %2 twice; give each column a name of its own.">(quoted(file_), shortened(names_[n])));
    std::vector<std::string> noTurn, noMatrix;
    const auto time = find("time", {{"_s", 1.0}, {"_ms", 1e-3}, {"_us", 1e-6}});
    const auto place = findAll(kPlace, true, noTurn), turn = findAll(kTurn, false, noTurn);
    const auto shift = findAll(kShift, true, noMatrix), rotation = findAll(kRotation, false, noMatrix);
    if (noTurn.empty() && noMatrix.empty())
      return refuse(say<"%1 says each pose twice, as a quaternion and as a matrix; take the columns of one away.">(quoted(file_)));
    if (!time || (!noTurn.empty() && !noMatrix.empty())) {
      // Of the two ways the one of which more is there.
      std::vector<std::string> missing = place.size() + turn.size() >= shift.size() + rotation.size() ? noTurn : noMatrix;
      if (noTurn.empty() || noMatrix.empty()) missing.clear();
      if (!time) missing.insert(missing.begin(), "time_s");
      return refuse(say<"%1 lacks %2 among its columns; it needs %3.">(quoted(file_), listOf(missing), needs()));
    }
    columns_.time = *time;
    columns_.place = noTurn.empty() ? place : shift;
    columns_.rotation = noTurn.empty() ? turn : rotation;
    if (!columns_.isMatrix() && (from_ == "Image" || to_ == "Image"))
      sequence_.notes.push_back(
          say<"%1 gives poses of Image by quaternions, which do not say how large a pixel is; 1 x 1 mm was taken.">(quoted(file_)));
    std::vector<std::string> noLastRow;
    if (columns_.isMatrix())
      if (auto row = findAll(kLastRow, false, noLastRow); noLastRow.empty()) columns_.lastRow = std::move(row);
    if (const auto status = find("status")) columns_.status = status->at;
    std::vector<std::string> unused;
    for (std::size_t n = 0; n < names_.size(); ++n)
      if (!isUsed_[n] && !names_[n].empty()) unused.push_back(shortened(names_[n]));
    if (!unused.empty())
      sequence_.notes.push_back(say<"Columns of %1 that are not known here and not used: %2.">(quoted(file_), listOf(unused)));
    return {};
  }

  /// The number of a column; NaN for blanks. Empty: something else stands there.
  std::optional<double> numberAt(const std::vector<std::string>& cells, const Column& column) const {
    std::string text = cells[column.at];
    if (text.empty()) return kNone;
    if (separator_ != ',') std::replace(text.begin(), text.end(), ',', '.');
    const auto number = parseNumber(text);
    if (!number) return std::nullopt;
    return *number * column.scale;
  }

  Result<std::vector<double>> numbersAt(const TableLine& line, const std::vector<std::string>& cells,
                                        const std::vector<Column>& columns) const {
    std::vector<double> numbers;
    for (const Column& column : columns) {
      const auto number = numberAt(cells, column);
      if (!number) return badLine(line.number, say<"%1 is \"%2\" and no number">(names_[column.at], shortened(cells[column.at])));
      numbers.push_back(*number);
    }
    return numbers;
  }

  Result<void> takeLine(const TableLine& line) {
    const std::vector<std::string> cells = cellsOf(line.text, separator_);
    if (separator_ == ',' && cells.size() > columns_.count)
      return badLine(line.number,
                     say<"there are %1 values for %2 columns; where numbers have decimal commas, semicolons must stand between "
                         "the columns">(cells.size(), columns_.count));
    if (cells.size() != columns_.count)
      return badLine(line.number,
                     counted<"there is %1 value for %2 columns", "there are %1 values for %2 columns">(cells.size(), columns_.count));
    const auto time_s = numberAt(cells, columns_.time);
    if (!time_s || !std::isfinite(*time_s))
      return badLine(line.number, say<"%1 is \"%2\" and no time">(names_[columns_.time.at], shortened(cells[columns_.time.at])));
    if (!sequence_.frames.empty() && !(*time_s > *sequence_.frames.back().time_s))
      return badLine(line.number, say<"the time is %1 s and does not rise above the %2 s of the pose before">(
                                      numeral(textOf(*time_s)), numeral(textOf(*sequence_.frames.back().time_s))));
    FrameTransform pose{from_, to_, glm::dmat4(1.0), PoseStatus::ok};
    if (columns_.status) {
      const auto status = statusOfWord(cells[*columns_.status]);
      if (!status)
        return badLine(line.number,
                       say<"the status is \"%1\", which is none of OK, INVALID and MISSING">(shortened(cells[*columns_.status])));
      pose.status = *status;
    }
    if (pose.status == PoseStatus::ok)
      if (auto taken = takePose(line, cells, pose); !taken) return taken;
    SequenceFrame frame;
    frame.time_s = *time_s;
    frame.transforms.push_back(std::move(pose));
    sequence_.frames.push_back(std::move(frame));
    return {};
  }

  Result<void> takePose(const TableLine& line, const std::vector<std::string>& cells, FrameTransform& pose) const {
    const auto place_mm = numbersAt(line, cells, columns_.place);
    if (!place_mm) return passOn(place_mm.error());
    const auto rotation = numbersAt(line, cells, columns_.rotation);
    if (!rotation) return passOn(rotation.error());
    std::vector<double> all = *place_mm;
    all.insert(all.end(), rotation->begin(), rotation->end());
    if (std::all_of(all.begin(), all.end(), [](double number) { return std::isnan(number); })) {
      pose.status = PoseStatus::missing;
      return {};
    }
    if (std::any_of(all.begin(), all.end(), [](double number) { return !std::isfinite(number); }))
      return badLine(line.number, say<"a number of the pose is blank, NaN or infinite, and others are not">());
    const std::vector<double>& r = *rotation;
    if (columns_.isMatrix()) {
      const auto last = numbersAt(line, cells, columns_.lastRow);
      if (!last) return passOn(last.error());
      const auto& t = *place_mm;
      std::array<double, 16> rows{r[0], r[1], r[2], t[0], r[3], r[4], r[5], t[1], r[6], r[7], r[8], t[2], 0.0, 0.0, 0.0, 1.0};
      if (!last->empty()) std::copy_n(last->begin(), 4, rows.begin() + 12);
      pose.matrix = matrixFromRows(rows);
    } else {
      const glm::dquat turn(r[0], r[1], r[2], r[3]);
      if (std::abs(glm::length(turn) - 1.0) > 0.01)
        return badLine(line.number,
                       say<"the quaternion has the length %1 instead of 1">(numeral(textOf(std::round(glm::length(turn) * 1e4) / 1e4))));
      pose.matrix = glm::dmat4(glm::mat3_cast(glm::normalize(turn)));
      pose.matrix[3] = glm::dvec4((*place_mm)[0], (*place_mm)[1], (*place_mm)[2], 1.0);
    }
    if (pose.from == "Image") {
      if (!isUsable(pose)) return badLine(line.number, say<"the matrix cannot be used: %1">(problemOf(pose)));
    } else if (const auto rigid = checkRigid(pose.matrix); !rigid) {
      return badLine(line.number, say<"the matrix is no rotation with a translation">());
    }
    return {};
  }

  fs::path file_;
  std::string from_ = "Probe";
  std::string to_ = "Tracker";
  std::size_t lineOfTransform_ = 0;  ///< that says so; 0: none does
  char separator_ = ',';
  std::vector<TableLine> lines_;
  std::vector<std::string> names_;
  std::vector<bool> isUsed_;
  TableColumns columns_;
  Sequence sequence_;
};

}  // namespace

Result<Sequence> readPoseTable(const fs::path& file) { return TableReader(file).read(); }

}  // namespace ew

#include "ply_file.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/glm.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/numbers.h"

namespace ew::bridge {
namespace {

enum class Format { ascii, littleEndian, bigEndian };
enum class Scalar { i8, u8, i16, u16, i32, u32, f32, f64 };

std::optional<Scalar> scalarOf(const std::string& name) {
  static const std::array<std::pair<const char*, Scalar>, 16> kNames{{{"char", Scalar::i8},
                                                                      {"int8", Scalar::i8},
                                                                      {"uchar", Scalar::u8},
                                                                      {"uint8", Scalar::u8},
                                                                      {"short", Scalar::i16},
                                                                      {"int16", Scalar::i16},
                                                                      {"ushort", Scalar::u16},
                                                                      {"uint16", Scalar::u16},
                                                                      {"int", Scalar::i32},
                                                                      {"int32", Scalar::i32},
                                                                      {"uint", Scalar::u32},
                                                                      {"uint32", Scalar::u32},
                                                                      {"float", Scalar::f32},
                                                                      {"float32", Scalar::f32},
                                                                      {"double", Scalar::f64},
                                                                      {"float64", Scalar::f64}}};
  for (const auto& [known, scalar] : kNames)
    if (name == known) return scalar;
  return std::nullopt;
}

std::size_t sizeOf(Scalar scalar) {
  switch (scalar) {
    case Scalar::i8:
    case Scalar::u8:
      return 1;
    case Scalar::i16:
    case Scalar::u16:
      return 2;
    case Scalar::f64:
      return 8;
    default:
      return 4;
  }
}

struct Property {
  std::string name;
  Scalar type = Scalar::f32;
  std::optional<Scalar> countType;  ///< a list when set
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
  [[nodiscard]] int indexOf(const std::string& wanted) const {
    for (std::size_t i = 0; i < properties.size(); ++i)
      if (properties[i].name == wanted) return static_cast<int>(i);
    return -1;
  }
};

struct Header {
  Format format = Format::ascii;
  std::vector<Element> elements;
};

/// Values one after the other, whatever the format; empty at the end of the file or at a word that is no number.
class Values {
 public:
  Values(std::istream& in, Format format) : in_(in), format_(format) {}

  std::optional<double> next(Scalar type) {
    if (format_ == Format::ascii) {
      std::string word;
      if (!(in_ >> word)) return std::nullopt;
      return parseNumber(word);
    }
    std::array<char, 8> bytes{};
    const std::size_t size = sizeOf(type);
    if (!in_.read(bytes.data(), static_cast<std::streamsize>(size))) return std::nullopt;
    if ((format_ == Format::bigEndian) != (std::endian::native == std::endian::big))
      std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    switch (type) {
      case Scalar::i8:
        return as<std::int8_t>(bytes);
      case Scalar::u8:
        return as<std::uint8_t>(bytes);
      case Scalar::i16:
        return as<std::int16_t>(bytes);
      case Scalar::u16:
        return as<std::uint16_t>(bytes);
      case Scalar::i32:
        return as<std::int32_t>(bytes);
      case Scalar::u32:
        return as<std::uint32_t>(bytes);
      case Scalar::f32:
        return as<float>(bytes);
      case Scalar::f64:
        return as<double>(bytes);
    }
    return std::nullopt;
  }

 private:
  template <class T>
  static double as(const std::array<char, 8>& bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
  }
  std::istream& in_;
  Format format_;
};

class PlyReader {
 public:
  PlyReader(std::filesystem::path file, std::uint64_t bytes, std::uint64_t mostFaces)
      : file_(std::move(file)), bytes_(bytes), mostFaces_(mostFaces), in_(file_, std::ios::binary) {}

  Result<vtkSmartPointer<vtkPolyData>> read() {
    const auto header = readHeader();
    if (!header) return passOn(header.error());
    Values values(in_, header->format);
    for (const Element& element : header->elements) {
      const auto read = element.name == "vertex" ? readVertices(element, values)
                        : element.name == "face" ? readFaces(element, values)
                                                 : skip(element, values);
      if (!read) return passOn(read.error());
    }
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points_);
    mesh->SetPolys(faces_);
    return mesh;
  }

 private:
  [[nodiscard]] std::string name() const { return file_.filename().string(); }
  [[nodiscard]] tl::unexpected<Error> refuse(ErrorCode code, const Message& sentence) const {
    return failure(code, sentence, {{"file", file_.string()}});
  }
  [[nodiscard]] tl::unexpected<Error> endedEarly(const Element& element, std::uint64_t index) const {
    return refuse(ErrorCode::truncated, say<"%1 ends, or holds something other than a number, in %2 %3 of %4; export the mesh again.">(
                                            name(), element.name, index, element.count));
  }

  bool nextLine(std::string& line) {
    line.clear();
    char c = 0;
    while (line.size() < 4096 && in_.get(c) && c != '\n') line.push_back(c);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return static_cast<bool>(in_);
  }

  Result<Header> readHeader() {
    std::string line;
    if (!nextLine(line) || line != "ply")
      return refuse(ErrorCode::badHeader, say<"%1 does not begin with \"ply\"; it is not a PLY file.">(name()));
    Header header;
    for (int lines = 0; lines < 1000; ++lines) {
      if (!nextLine(line)) break;
      std::istringstream words(line);
      std::string word;
      words >> word;
      const auto unclear = [&] {
        return refuse(ErrorCode::badHeader,
                      say<"%1 says \"%2\" in its header, which cannot be read; export the mesh again.">(name(), line));
      };
      if (word == "end_header") return checked(std::move(header));
      if (word == "format") {
        words >> word;
        if (word == "ascii")
          header.format = Format::ascii;
        else if (word == "binary_little_endian")
          header.format = Format::littleEndian;
        else if (word == "binary_big_endian")
          header.format = Format::bigEndian;
        else
          return unclear();
      } else if (word == "element") {
        Element element;
        std::string count;
        words >> element.name >> count;
        const auto parsed = parseIntegers(count);
        if (!parsed || parsed->size() != 1 || parsed->front() < 0) return unclear();
        element.count = static_cast<std::uint64_t>(parsed->front());
        header.elements.push_back(element);
      } else if (word == "property") {
        if (header.elements.empty()) return unclear();
        Property property;
        words >> word;
        if (word == "list") {
          words >> word;
          property.countType = scalarOf(word);
          if (!property.countType) return unclear();
          words >> word;
        }
        const auto type = scalarOf(word);
        if (!type || !(words >> property.name)) return unclear();
        property.type = *type;
        header.elements.back().properties.push_back(property);
      }
    }
    return refuse(ErrorCode::badHeader, say<"%1 has no end of its PLY header; export the mesh again.">(name()));
  }

  /// Holds the promised counts against the file's size: a value takes its bytes, in text a digit and a space.
  Result<Header> checked(Header header) const {
    bool hasPoints = false;
    bool hasFaces = false;
    double promised = 0.0;
    for (const Element& element : header.elements) {
      hasPoints = hasPoints || (element.name == "vertex" && element.count > 0);
      hasFaces = hasFaces || (element.name == "face" && element.count > 0);
      if (element.count > mostFaces_)
        return refuse(ErrorCode::tooLarge,
                      say<"%1 promises %2 of \"%3\"; use a mesh with at most %4.">(name(), element.count, element.name, mostFaces_));
      for (const Property& property : element.properties)
        promised += static_cast<double>(element.count) *
                    (header.format == Format::ascii ? 2.0 : static_cast<double>(sizeOf(property.countType.value_or(property.type))));
    }
    if (!hasPoints || !hasFaces)
      return refuse(ErrorCode::emptyVolume, say<"%1 has no triangles; export the body as a surface mesh.">(name()));
    if (promised > static_cast<double>(bytes_) + 1.0)
      return refuse(ErrorCode::truncated, say<"%1 is shorter than its header promises; export the mesh again.">(name()));
    return header;
  }

  /// The values of a list, or of one scalar; empty when the file ends or the count cannot be.
  std::optional<std::vector<double>> readProperty(const Property& property, Values& values) const {
    std::size_t count = 1;
    if (property.countType) {
      const auto said = values.next(*property.countType);
      if (!said || *said < 0.0 || *said > static_cast<double>(bytes_) || *said != std::floor(*said)) return std::nullopt;
      count = static_cast<std::size_t>(*said);
    }
    std::vector<double> all;
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = values.next(property.type);
      if (!value) return std::nullopt;
      all.push_back(*value);
    }
    return all;
  }

  Result<void> skip(const Element& element, Values& values) {
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i)
      for (const Property& property : element.properties)
        if (!readProperty(property, values)) return endedEarly(element, i);
    return {};
  }

  Result<void> readVertices(const Element& element, Values& values) {
    const std::array<int, 3> axes{element.indexOf("x"), element.indexOf("y"), element.indexOf("z")};
    if (*std::min_element(axes.begin(), axes.end()) < 0)
      return refuse(ErrorCode::badField, say<"%1 has points without x, y and z; export the mesh again.">(name()));
    points_->SetNumberOfPoints(static_cast<vtkIdType>(element.count));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      glm::dvec3 p(0.0);
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const auto read = readProperty(element.properties[k], values);
        if (!read) return endedEarly(element, i);
        for (std::size_t axis = 0; axis < 3; ++axis)
          if (axes[axis] == static_cast<int>(k) && !read->empty()) p[static_cast<glm::length_t>(axis)] = read->front();
      }
      points_->SetPoint(static_cast<vtkIdType>(i), &p.x);
    }
    return {};
  }

  Result<void> readFaces(const Element& element, Values& values) {
    const int listAt = std::max(element.indexOf("vertex_indices"), element.indexOf("vertex_index"));
    if (listAt < 0) return refuse(ErrorCode::badField, say<"%1 has faces without vertex_indices; export the mesh again.">(name()));
    std::vector<vtkIdType> corners;
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const auto read = readProperty(element.properties[k], values);
        if (!read) return endedEarly(element, i);
        if (static_cast<int>(k) != listAt || read->size() < 3) continue;
        corners.clear();
        for (const double value : *read) corners.push_back(std::abs(value) < 1e15 ? static_cast<vtkIdType>(value) : -1);
        faces_->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
      }
    return {};
  }

  std::filesystem::path file_;
  std::uint64_t bytes_;
  std::uint64_t mostFaces_;
  std::ifstream in_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> faces_;
};

}  // namespace

Result<vtkSmartPointer<vtkPolyData>> readPly(const std::filesystem::path& file, std::uint64_t bytes, std::uint64_t mostFaces) {
  return PlyReader(file, bytes, mostFaces).read();
}

}  // namespace ew::bridge

#include "mesh_file.h"

#include <vtkCallbackCommand.h>

#include <vtkCellArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>
#include <glm/glm.hpp>
#include <sstream>

#include "ew/core/numbers.h"
#include "ply_file.h"

namespace ew::bridge {
namespace {

constexpr std::uint64_t kMostTriangles = 20'000'000;

struct MeshFile {
  std::filesystem::path path;
  std::uint64_t bytes = 0;

  [[nodiscard]] std::string name() const { return path.filename().string(); }
  [[nodiscard]] tl::unexpected<Error> refuse(ErrorCode code, const Message& sentence) const {
    return failure(code, sentence, {{"file", path.string()}});
  }
  [[nodiscard]] tl::unexpected<Error> tooManyTriangles(std::uint64_t count) const {
    return refuse(ErrorCode::tooLarge, say<"%1 promises %2 triangles; use a mesh with at most 20 million.">(name(), count));
  }
};

/// A binary STL says in its header how many triangles of 50 bytes follow; the reader would believe it.
Result<void> checkStl(const MeshFile& file) {
  std::ifstream in(file.path, std::ios::binary);
  std::array<char, 84> head{};
  in.read(head.data(), head.size());
  const bool startsAsText = std::strncmp(head.data(), "solid", 5) == 0;
  if (in.gcount() < 84) {
    if (startsAsText) return {};
    return file.refuse(ErrorCode::truncated, say<"%1 ends inside the header of a binary STL file; export the mesh again.">(file.name()));
  }
  std::uint32_t count = 0;
  std::memcpy(&count, head.data() + 80, 4);
  const std::uint64_t promised = 84 + 50ull * count;
  // Some programs write "solid" into binary files as well: then only the size tells.
  if (startsAsText && promised != file.bytes) return {};
  if (count > kMostTriangles && promised <= file.bytes) return file.tooManyTriangles(count);
  if (promised > file.bytes)
    return file.refuse(ErrorCode::truncated, say<"%1 promises %2 triangles but ends after %3; export the mesh again.">(
                                                 file.name(), count, (file.bytes - 84) / 50));
  return {};
}

/// Corners that do not exist would be looked up all the same, so the faces of an OBJ file are checked before the reader sees them.
Result<void> checkObj(const MeshFile& file) {
  std::ifstream in(file.path);
  std::string line;
  std::array<long long, 3> counts{0, 0, 0};  // v, vt, vn
  struct Highest {
    long long index = 0;
    std::string corner;
    std::uint64_t line = 0;
  };
  std::array<Highest, 3> highest;  // named by a face; points may come after the faces that use them
  std::uint64_t faces = 0;
  const auto noSuchCorner = [&](const std::string& corner, std::uint64_t number) {
    return file.refuse(
        ErrorCode::badField,
        say<"%1 has a face with the corner \"%2\", which does not exist (line %3); export the mesh again.">(file.name(), corner, number));
  };
  for (std::uint64_t number = 1; std::getline(in, line); ++number) {
    if (line.find('\0') != std::string::npos)
      return file.refuse(ErrorCode::badHeader, say<"%1 is not text, which an OBJ file is; export the mesh again.">(file.name()));
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v" || word == "vt" || word == "vn") {
      ++counts[word == "v" ? 0 : word == "vt" ? 1 : 2];
      const int least = word == "vt" ? 1 : 3;
      int found = 0;
      for (std::string value; words >> value; ++found)
        if (const auto parsed = parseNumber(value); !parsed || !std::isfinite(*parsed))
          return file.refuse(ErrorCode::badField,
                             say<"%1 has \"%2\" for a coordinate (line %3); export the mesh again.">(file.name(), value, number));
      if (found < least)
        return file.refuse(ErrorCode::badField,
                           say<"%1 has a point with fewer than three coordinates (line %2); export the mesh again.">(file.name(), number));
    } else if (word == "f") {
      ++faces;
      if (faces > kMostTriangles) return file.tooManyTriangles(faces);
      int corners = 0;
      for (std::string corner; words >> corner; ++corners) {
        std::istringstream parts(corner);
        std::string part;
        for (std::size_t kind = 0; kind < 3 && std::getline(parts, part, '/'); ++kind) {
          if (part.empty() && kind == 1) continue;
          const auto parsed = parseIntegers(part);
          const long long index = parsed && parsed->size() == 1 ? parsed->front() : 0;
          if (index == 0 || index < -counts[kind]) return noSuchCorner(corner, number);
          if (index > highest[kind].index) highest[kind] = {index, corner, number};
        }
      }
      if (corners < 3)
        return file.refuse(ErrorCode::badField,
                           say<"%1 has a face with fewer than three corners (line %2); export the mesh again.">(file.name(), number));
    }
  }
  for (std::size_t kind = 0; kind < 3; ++kind)
    if (highest[kind].index > counts[kind]) return noSuchCorner(highest[kind].corner, highest[kind].line);
  if (faces == 0) return file.refuse(ErrorCode::emptyVolume, say<"%1 has no triangles; export the body as a surface mesh.">(file.name()));
  return {};
}

template <class Reader>
Result<vtkSmartPointer<vtkPolyData>> readWith(const MeshFile& file) {
  vtkNew<Reader> reader;
  std::string problem;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&problem);
  listener->SetCallback([](vtkObject*, unsigned long, void* to, void* text) {
    auto& kept = *static_cast<std::string*>(to);
    if (kept.empty() && text != nullptr) kept = static_cast<const char*>(text);
  });
  for (vtkObject* speaker : {static_cast<vtkObject*>(reader.Get()), static_cast<vtkObject*>(reader->GetExecutive())}) {
    speaker->AddObserver(vtkCommand::ErrorEvent, listener);
    speaker->AddObserver(vtkCommand::WarningEvent, listener);
  }
  reader->SetFileName(file.path.c_str());
  try {
    reader->Update();
  } catch (const std::exception& thrown) {
    problem = thrown.what();
  }
  if (!problem.empty() || reader->GetErrorCode() != 0) {
    auto refused = file.refuse(ErrorCode::badHeader, say<"%1 cannot be read as a mesh; export it again as STL, PLY or OBJ.">(file.name()));
    refused.value().context.emplace_back("reader", problem);
    return refused;
  }
  return vtkSmartPointer<vtkPolyData>(reader->GetOutput());
}

Result<void> checkMesh(const MeshFile& file, vtkPolyData& mesh) {
  const vtkIdType points = mesh.GetNumberOfPoints();
  if (points == 0 || mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() == 0)
    return file.refuse(ErrorCode::emptyVolume, say<"%1 has no triangles; export the body as a surface mesh.">(file.name()));
  if (static_cast<std::uint64_t>(mesh.GetNumberOfPolys()) > kMostTriangles)
    return file.tooManyTriangles(static_cast<std::uint64_t>(mesh.GetNumberOfPolys()));
  for (vtkIdType id = 0; id < points; ++id) {
    glm::dvec3 p;
    mesh.GetPoint(id, &p.x);
    for (int axis = 0; axis < 3; ++axis)
      if (!std::isfinite(p[axis]))
        return file.refuse(ErrorCode::badField,
                           say<"%1 has a point whose coordinates are not finite; export the mesh again.">(file.name()));
  }
  for (vtkCellArray* cells : {mesh.GetPolys(), mesh.GetStrips()})
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(cell, count, ids);
      for (vtkIdType corner = 0; corner < count; ++corner)
        if (ids[corner] < 0 || ids[corner] >= points)
          return file.refuse(ErrorCode::badField,
                             say<"%1 has a face with corner %2, which does not exist; export the mesh again.">(file.name(), ids[corner]));
    }
  return {};
}

}  // namespace

Result<vtkSmartPointer<vtkPolyData>> readMeshFile(const std::filesystem::path& file, const std::string& ending) {
  std::error_code problem;
  const MeshFile mesh{file, std::filesystem::file_size(file, problem)};
  if (problem || !std::ifstream(file, std::ios::binary))
    return mesh.refuse(ErrorCode::notReadable, say<"%1 cannot be read; check that you may open it.">(mesh.name()));
  if (mesh.bytes == 0) return mesh.refuse(ErrorCode::emptyVolume, say<"%1 is an empty file; export the mesh again.">(mesh.name()));
  if (ending != ".ply") {
    const auto checked = ending == ".stl" ? checkStl(mesh) : checkObj(mesh);
    if (!checked) return passOn(checked.error());
  }
  auto read = ending == ".stl"   ? readWith<vtkSTLReader>(mesh)
              : ending == ".ply" ? readPly(file, mesh.bytes, kMostTriangles)
                                 : readWith<vtkOBJReader>(mesh);
  if (!read) return read;
  if (const auto whole = checkMesh(mesh, **read); !whole) return passOn(whole.error());
  return read;
}

}  // namespace ew::bridge

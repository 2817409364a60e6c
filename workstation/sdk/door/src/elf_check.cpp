#include "elf_check.h"

#include <elf.h>

#include <array>
#include <cstring>
#include <fstream>

namespace ew::door {
namespace {

using Header = Elf64_Ehdr;
using Segment = Elf64_Phdr;

#if defined(__x86_64__)
constexpr Elf64_Half kMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr Elf64_Half kMachine = EM_AARCH64;
#else
constexpr Elf64_Half kMachine = EM_NONE;  // not known: the loader's own check has to do
#endif

/// Whether [offset, offset + count * size) lies inside the file, without overflow.
bool inside(std::uint64_t fileSize, std::uint64_t offset, std::uint64_t count, std::uint64_t size) {
  if (offset > fileSize) return false;
  return size == 0 || count <= (fileSize - offset) / size;
}

}  // namespace

Message whyNotALibrary(const std::filesystem::path& file) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in) return say<"it cannot be read">();
  std::array<char, sizeof(Header)> bytes{};
  in.read(bytes.data(), bytes.size());
  const auto got = static_cast<std::size_t>(in.gcount());
  if (got < SELFMAG || std::memcmp(bytes.data(), ELFMAG, SELFMAG) != 0) return say<"it is not a library">();
  if (got < bytes.size()) return say<"it is cut off">();
  Header header;
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_ident[EI_DATA] != ELFDATA2LSB ||
      (kMachine != EM_NONE && header.e_machine != kMachine))
    return say<"it is a library of another kind of machine">();
  if (header.e_type != ET_DYN || header.e_phentsize != sizeof(Segment)) return say<"it is not a library">();
  if (!inside(size, header.e_phoff, header.e_phnum, sizeof(Segment)) || !inside(size, header.e_shoff, header.e_shnum, header.e_shentsize))
    return say<"it is cut off">();
  in.seekg(static_cast<std::streamoff>(header.e_phoff));
  for (int n = 0; n < header.e_phnum; ++n) {
    std::array<char, sizeof(Segment)> entry{};
    if (!in.read(entry.data(), entry.size())) return say<"it is cut off">();
    Segment segment;
    std::memcpy(&segment, entry.data(), sizeof segment);
    if (!inside(size, segment.p_offset, segment.p_filesz, 1)) return say<"it is cut off">();
  }
  return {};
}

}  // namespace ew::door

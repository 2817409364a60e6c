#include "ew/core/file_errors.h"

#include <cerrno>
#include <system_error>

namespace ew {
namespace {
namespace fs = std::filesystem;

Message reasonOf(int number) { return verbatim(std::generic_category().message(number)); }

/// Of this program, or of all on this machine: neither permissions nor room would help.
bool isOutOfFiles(int number) { return number == EMFILE || number == ENFILE; }

}  // namespace

tl::unexpected<Error> notOpened(const fs::path& file, int number) {
  const Message name = say<"\"%1\"">(file.filename());
  Error error{ErrorCode::notReadable, {}, {{"file", file.string()}}};
  if (isOutOfFiles(number))
    error.message =
        say<"%1 cannot be opened, because too many files are open at the moment; close other windows or programs and try again.">(name);
  else if (number != 0)
    error.message = say<"%1 cannot be opened (%2); check its permissions.">(name, reasonOf(number));
  else
    error.message = say<"%1 cannot be opened; check its permissions.">(name);
  return tl::unexpected<Error>(std::move(error));
}

tl::unexpected<Error> notListed(const fs::path& folder, int number) {
  if (isOutOfFiles(number)) return notOpened(folder, number);
  return failure(ErrorCode::notReadable, say<"%1 cannot be listed; check its permissions.">(say<"\"%1\"">(folder.filename())),
                 {{"file", folder.string()}});
}

tl::unexpected<Error> notWritable(const fs::path& file, Message reason) {
  std::string english = reason.english();
  return failure(ErrorCode::notWritable,
                 say<"\"%1\" cannot be written (%2); choose another place or free some room.">(file, std::move(reason)),
                 {{"file", file.string()}, {"reason", std::move(english)}});
}

tl::unexpected<Error> notWritable(const fs::path& file, int number) {
  if (!isOutOfFiles(number)) return notWritable(file, reasonOf(number));
  return failure(
      ErrorCode::notWritable,
      say<"\"%1\" cannot be written, because too many files are open at the moment; close other windows or programs and try again.">(file),
      {{"file", file.string()}, {"reason", reasonOf(number).english()}});
}

}  // namespace ew

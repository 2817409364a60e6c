#include "access/sealed_file.h"

#include <gtest/gtest.h>

#include "library/temporary_folder.h"

namespace ew::test::sealed_file_test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece_bytes = 64u << 10;

/// A sealed file of any content, looked at from outside.
class SealedFile : public ::testing::Test {
 protected:
  void seal(const std::string& content) const {
    fs::remove(file_);
    auto sealed = sealFile(file_, "exam", std::string(64, 'a'), {key_.publicKey()}, [&](const TakePiece& put) -> Result<void> {
      for (std::size_t at = 0; at < content.size(); at += 1000)  // pieces of another size than the stream's
        if (auto written = put(std::as_bytes(std::span(content).subspan(at, std::min<std::size_t>(1000, content.size() - at)))); !written)
          return written;
      return {};
    });
    ASSERT_TRUE(sealed) << sealed.error();
  }
  [[nodiscard]] Result<std::string> opened() const {
    std::string content;
    ByteCount count(say<"Opening the sealed answers">(), 0, noProgress());
    auto read = openSealedFile(file_, key_, count, [&](std::span<const std::byte> piece) -> Result<void> {
      content.append(reinterpret_cast<const char*>(piece.data()), piece.size());
      return {};
    });
    if (!read) return passOn(read.error());
    return content;
  }
  [[nodiscard]] static std::size_t headerEnd(const std::string& bytes) {
    return 16u + static_cast<unsigned char>(bytes[12]) + 256u * static_cast<unsigned char>(bytes[13]);
  }
  const TemporaryFolder folder_;
  const fs::path file_ = folder_ / "sealed";
  const SecretKey key_ = *SecretKey::make();
};

TEST_F(SealedFile, ComesBackWhateverItsLength) {
  for (const std::size_t length : {std::size_t(0), std::size_t(1), kPiece_bytes - 1, kPiece_bytes, kPiece_bytes + 1, 2 * kPiece_bytes}) {
    std::string content(length, 'x');
    for (std::size_t n = 0; n < length; ++n) content[n] = static_cast<char>(n * 31);
    seal(content);
    EXPECT_EQ(opened(), content) << length;
  }
}

TEST_F(SealedFile, IsRefusedWhenAnyByteBeforeItsStreamWasChanged) {
  seal("answers");
  const std::string whole = textOf(file_);
  for (std::size_t at = 0; at < headerEnd(whole); ++at)
    for (const char bit : {1, 4, 32}) {
      std::string wrong = whole;
      wrong[at] = static_cast<char>(wrong[at] ^ bit);
      writeText(file_, wrong);
      EXPECT_FALSE(opened()) << at << ": " << wrong.substr(16, headerEnd(whole) - 16);
    }
}

TEST_F(SealedFile, IsRefusedWhenItSaysToBeForSomebodyElse) {
  seal("answers");
  std::string wrong = textOf(file_);
  const auto name = wrong.find(shortNameOf(key_.publicKey()));
  ASSERT_NE(name, std::string::npos);
  wrong.replace(name, 19, "0000-0000-0000-0000");
  writeText(file_, wrong);
  EXPECT_FALSE(opened()) << "the header is JSON as before, and its slot opens";
}

TEST_F(SealedFile, IsRefusedWhenSomethingStandsBehindAFullLastPiece) {
  for (const std::size_t length : {std::size_t(10), kPiece_bytes, 2 * kPiece_bytes}) {
    seal(std::string(length, 'x'));
    const std::string whole = textOf(file_);
    for (const std::string& more : {std::string("x"), std::string(100, 'x'), whole.substr(whole.size() - 27)}) {
      writeText(file_, whole + more);
      EXPECT_FALSE(opened()) << length << " " << more.size();
    }
  }
}

TEST_F(SealedFile, IsRefusedWhenPiecesAreCutOffOrExchanged) {
  seal(std::string(3 * kPiece_bytes, 'x'));
  const std::string whole = textOf(file_);
  const std::size_t begin = headerEnd(whole) + 24, piece = kPiece_bytes + 17;
  ASSERT_EQ(whole.size(), begin + 3 * piece);
  writeText(file_, whole.substr(0, begin + 2 * piece));
  EXPECT_FALSE(opened()) << "the last piece is missing";
  writeText(file_, whole.substr(0, begin) + whole.substr(begin + piece));
  EXPECT_FALSE(opened()) << "the first piece is missing";
  writeText(file_,
            whole.substr(0, begin) + whole.substr(begin + piece, piece) + whole.substr(begin, piece) + whole.substr(begin + 2 * piece));
  EXPECT_FALSE(opened()) << "two are exchanged";
  writeText(file_, whole);
  EXPECT_TRUE(opened());
}

TEST_F(SealedFile, IsAnotherOneEachTime) {
  seal("answers");
  const std::string first = textOf(file_);
  seal("answers");
  EXPECT_NE(textOf(file_), first);
}

}  // namespace
}  // namespace ew::test::sealed_file_test

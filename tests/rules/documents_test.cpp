#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "places.h"

// What documents say of each other is true: a link leads to a file that is there, and to a heading that is in it, and every page is reached
// by a link from another one.
namespace ew::rules::documents_test {
namespace {

namespace fs = std::filesystem;

struct Page {
  std::string path;  ///< from the top of the tree: "resources/docs/README.md"
  std::string text;
};

/// What `[words](target)` leads to.
struct Link {
  int line = 0;  ///< from 1
  std::string target;
  bool operator==(const Link&) const = default;
};

/// The text of a document at a path from the top of the tree, empty for a folder and for what is no document; none where nothing is.
using Lookup = std::function<std::optional<std::string>(const std::string&)>;

/// The lines of a document, empty where they stand between fences.
std::vector<std::string> proseOf(const std::string& text) {
  std::vector<std::string> lines;
  bool isFenced = false;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    const std::size_t first = line.find_first_not_of(' ');
    const bool isFence = first != std::string::npos && line.compare(first, 3, "```") == 0;
    if (isFence) isFenced = !isFenced;
    lines.push_back(isFence || isFenced ? std::string() : std::move(line));
    begin = end + 1;
  }
  return lines;
}

/// What stands between two backticks as spaces.
std::string withoutCode(std::string line) {
  for (std::size_t begin = line.find('`'); begin != std::string::npos;) {
    const std::size_t end = line.find('`', begin + 1);
    if (end == std::string::npos) break;
    std::fill(line.begin() + static_cast<std::ptrdiff_t>(begin), line.begin() + static_cast<std::ptrdiff_t>(end) + 1, ' ');
    begin = line.find('`', end + 1);
  }
  return line;
}

std::vector<Link> linksOf(const std::string& text) {
  std::vector<Link> links;
  int number = 0;
  for (const std::string& prose : proseOf(text)) {
    ++number;
    const std::string line = withoutCode(prose);
    for (std::size_t at = line.find("]("); at != std::string::npos; at = line.find("](", at + 2)) {
      const std::size_t end = line.find_first_of(" )", at + 2);  // a title stands behind a space
      if (end != std::string::npos) links.push_back({number, line.substr(at + 2, end - at - 2)});
    }
  }
  return links;
}

/// A heading as links name it: small letters, hyphens for spaces, no punctuation.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (std::size_t at = 0; at < heading.size();) {
    const auto first = static_cast<unsigned char>(heading[at]);
    if (first < 0x80) {
      if (std::isalnum(first) != 0 || first == '-' || first == '_')
        anchor += static_cast<char>(std::tolower(first));
      else if (first == ' ')
        anchor += '-';
      ++at;
      continue;
    }
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    std::string letter = heading.substr(at, length);
    const bool isSign = first == 0xC2 || first == 0xE2 || letter == "\u00d7" || letter == "\u00f7";  // ° · … – ×
    if (first == 0xC3 && letter.size() == 2 && static_cast<unsigned char>(letter[1]) < 0x9F)         // Ä to ä
      letter[1] = static_cast<char>(static_cast<unsigned char>(letter[1]) + 0x20);
    if (!isSign) anchor += letter;
    at += length;
  }
  return anchor;
}

/// All headings of a document as links name them; of several alike the second ends in "-1".
std::set<std::string> anchorsOf(const std::string& text) {
  static const std::regex kHeading("#{1,6} +(.*?)[ #]*"), kLink("\\[([^\\]]*)\\]\\([^)]*\\)");
  std::set<std::string> anchors;
  std::map<std::string, int> seen;
  std::smatch match;
  for (const std::string& line : proseOf(text))
    if (line.starts_with('#') && std::regex_match(line, match, kHeading)) {
      const std::string anchor = anchorOf(std::regex_replace(match[1].str(), kLink, "$1"));
      const int before = seen[anchor]++;
      anchors.insert(before == 0 ? anchor : anchor + "-" + std::to_string(before));
    }
  return anchors;
}

bool leavesTheTree(const std::string& target) {
  static const std::regex kScheme("[A-Za-z][A-Za-z0-9+.-]*:.*");
  return std::regex_match(target, kScheme);
}

/// Where a link of a page leads, from the top of the tree and without the heading.
std::string fileOf(const Page& page, const std::string& target) {
  const std::string file = target.substr(0, target.find('#'));
  if (file.empty()) return page.path;
  std::string path = (fs::path(page.path).parent_path() / file).lexically_normal().generic_string();
  if (path.ends_with('/')) path.pop_back();
  return path;
}

/// A line for each link that leads nowhere.
std::string deadLinksOf(const Page& page, const Lookup& lookup) {
  std::string said;
  for (const Link& link : linksOf(page.text)) {
    if (leavesTheTree(link.target)) continue;
    const std::string file = fileOf(page, link.target);
    const std::size_t mark = link.target.find('#');
    const auto text = lookup(file);
    const std::string place = page.path + ":" + std::to_string(link.line) + ": " + link.target;
    if (!text)
      said += place + ": there is no such file\n";
    else if (mark != std::string::npos && file.ends_with(".md") && !anchorsOf(*text).contains(link.target.substr(mark + 1)))
      said += place + ": there is no such heading\n";
  }
  return said;
}

/// Those of `wanted` that no page but themselves links.
std::vector<std::string> unlinkedOf(const std::vector<std::string>& wanted, const std::vector<Page>& pages) {
  std::set<std::string> linked;
  for (const Page& page : pages)
    for (const Link& link : linksOf(page.text))
      if (!leavesTheTree(link.target) && fileOf(page, link.target) != page.path) linked.insert(fileOf(page, link.target));
  std::vector<std::string> unlinked;
  std::ranges::copy_if(wanted, std::back_inserter(unlinked), [&](const std::string& path) { return !linked.contains(path); });
  return unlinked;
}

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::optional<std::string> inTree(const std::string& path) {
  const fs::path file = fs::path(EW_SOURCE_DIR) / path;
  if (path.starts_with("..") || !fs::exists(file)) return std::nullopt;
  return file.extension() == ".md" ? textOf(file) : std::string();
}

/// Every document of the tree, sorted by path.
std::vector<Page> documents() {
  const fs::path top = EW_SOURCE_DIR;
  std::vector<Page> pages;
  const auto add = [&](const fs::path& file) {
    if (file.extension() == ".md" && fs::is_regular_file(file)) pages.push_back({fs::relative(file, top).generic_string(), textOf(file)});
  };
  for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"}) add(top / name);
  for (const auto& entry : fs::recursive_directory_iterator(top / "resources" / "docs")) add(entry.path());
  for (const auto& entry : fs::directory_iterator(top / "resources" / "decisions")) add(entry.path());
  for (const char* home : {"workstation", "plugins"})
    for (const auto& entry : fs::directory_iterator(top / home)) add(entry.path() / "README.md");
  std::ranges::sort(pages, {}, &Page::path);
  return pages;
}

/// The pages of resources/docs, those that are no text for reading in an editor too.
std::vector<std::string> pagesOfDocs() {
  const fs::path top = EW_SOURCE_DIR;
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(top / "resources" / "docs"))
    if (entry.path().extension() == ".md" || entry.path().extension() == ".html")
      paths.push_back(fs::relative(entry.path(), top).generic_string());
  std::ranges::sort(paths);
  return paths;
}

TEST(Documents, AreRead) {
  const auto pages = documents();
  for (const char* path : {"README.md", "CONTRIBUTING.md", "resources/docs/README.md", "resources/docs/science/hard-cases.md"})
    EXPECT_TRUE(std::ranges::find(pages, path, &Page::path) != pages.end()) << path;
}

TEST(Documents, LinkToFilesAndHeadingsThatAreThere) {
  std::string dead;
  for (const Page& page : documents()) dead += deadLinksOf(page, inTree);
  EXPECT_EQ(dead, "");
}

TEST(Documents, AreEachReachedByALink) {
  std::string said;
  for (const std::string& path : unlinkedOf(pagesOfDocs(), documents())) said += path + "\n";
  EXPECT_EQ(said, "") << "Instead: give each a line in resources/docs/README.md.";
}

/// `Suite.Test` and `gui_NAME function` of a page that no source of tests holds, a line each.
std::string unknownTestsIn(const std::string& page, const std::string& sourcesOfTests) {
  static const std::regex googleTest("`(\\w+)\\.(\\w+)`"), windowTest("`gui_\\w+ (\\w+)`");
  std::string unknown;
  for (std::sregex_iterator each(page.begin(), page.end(), googleTest), end; each != end; ++each) {
    const std::string suite = (*each)[1], test = (*each)[2];
    const bool isThere = sourcesOfTests.find("(" + suite + ", " + test + ")") != std::string::npos;
    if (!isThere && suite != "Suite") unknown += suite + "." + test + "\n";
  }
  for (std::sregex_iterator each(page.begin(), page.end(), windowTest), end; each != end; ++each) {
    const std::string function = (*each)[1];
    if (sourcesOfTests.find("void " + function + "(") == std::string::npos && function != "function") unknown += function + "\n";
  }
  return unknown;
}

TEST(Documents, NameTestsThatAreThere) {
  std::string sourcesOfTests;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(EW_SOURCE_DIR) / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    std::ifstream in(entry.path());
    sourcesOfTests.append(std::istreambuf_iterator<char>(in), {});
  }
  const auto page = inTree("resources/docs/developer/review-tests.md");
  ASSERT_TRUE(page);
  EXPECT_EQ(unknownTestsIn(*page, sourcesOfTests), "") << "Instead: name the test that holds it now.";
  EXPECT_EQ(unknownTestsIn("`Pose.Moves` and `gui_window opens`, `Gone.Is`, `gui_window closes`", "TEST(Pose, Moves) { } void opens() {"),
            "Gone.Is\ncloses\n");
}

TEST(Documents, LinksThatLeadNowhereAreFound) {
  const std::map<std::string, std::string> tree = {{"docs/a.md", "# A\n\n## Two words\n"}, {"docs/sub", ""}, {"top.png", ""}};
  const Lookup lookup = [&](const std::string& path) {
    const auto at = tree.find(path);
    return at == tree.end() ? std::nullopt : std::optional<std::string>(at->second);
  };
  EXPECT_EQ(
      deadLinksOf({"docs/b.md", "[a](a.md), [words](a.md#two-words), ![](../top.png), [sub](sub/)\n[out](https://a.example/x.md)"}, lookup),
      "");
  EXPECT_EQ(deadLinksOf({"docs/b.md", "x\n[c](c.md)"}, lookup), "docs/b.md:2: c.md: there is no such file\n");
  EXPECT_EQ(deadLinksOf({"docs/b.md", "[a](../a.md)"}, lookup), "docs/b.md:1: ../a.md: there is no such file\n");
  EXPECT_EQ(deadLinksOf({"docs/b.md", "[a](a.md#three)"}, lookup), "docs/b.md:1: a.md#three: there is no such heading\n");
  EXPECT_EQ(deadLinksOf({"docs/a.md", "[a](#gone)"}, lookup), "docs/a.md:1: #gone: there is no such heading\n");
}

TEST(Documents, LinksInCodeAreNone) {
  EXPECT_EQ(linksOf("[a](b.md) `[c](d.md)` [e](f.md \"title\")\n```\n[g](h.md)\n```\n[i](j.md)"),
            (std::vector<Link>{{1, "b.md"}, {1, "f.md"}, {5, "j.md"}}));
}

TEST(Documents, HeadingsAreNamedAsLinksNameThem) {
  EXPECT_EQ(anchorOf("Lag of poses (`temporal_offset.h`), \u2026"), "lag-of-poses-temporal_offseth-");
  EXPECT_EQ(anchorOf("\u00dcbung f\u00fcr Gr\u00f6\u00dfere"), "\u00fcbung-f\u00fcr-gr\u00f6\u00dfere");
  EXPECT_EQ(anchorsOf("# One\n## [Two](x.md)\n# One\n```\n# None\n```\n#no heading\n"), (std::set<std::string>{"one", "two", "one-1"}));
}

TEST(Documents, PagesThatNobodyLinksAreFound) {
  const std::vector<Page> pages = {{"docs/a.md", "[b](b.md#x)"}, {"docs/b.md", ""}, {"docs/c.md", "[c](c.md), [c](#c)"}};
  EXPECT_EQ(unlinkedOf({"docs/b.md", "docs/c.md"}, pages), (std::vector<std::string>{"docs/c.md"}));
}

}  // namespace
}  // namespace ew::rules::documents_test

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "ew/annotation/body_mark.h"
#include "ew/annotation/word_list.h"
#include "places.h"

namespace ew::annotation::schema_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kResources = fs::path(EW_SOURCE_DIR) / "resources";

json documentOf(const fs::path& file) { return json::parse(std::ifstream(file)); }

class Schema {
 public:
  explicit Schema(const std::string& name) : text_(documentOf(kResources / "schemas" / name)) {
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(valijson::adapters::NlohmannJsonAdapter(text_), schema_);
  }
  [[nodiscard]] bool accepts(const json& document) const {
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
  }

 private:
  json text_;
  valijson::Schema schema_;
};

using Reads = std::function<bool(const json&)>;

/// Whole files, then each object of them with one field less or one more: schema and reader must agree.
void compare(const Schema& schema, const Reads& reads, const json& whole, const std::string& name) {
  EXPECT_TRUE(schema.accepts(whole)) << name;
  EXPECT_TRUE(reads(whole)) << name;
  int objects = 0;
  const std::function<void(const json&, const json::json_pointer&)> visit = [&](const json& part, const json::json_pointer& at) {
    if (part.is_object()) {
      if (++objects > 8) return;  // the first ones of each file say it
      for (const auto& field : part.items()) {
        json less = whole;
        less[at].erase(field.key());
        EXPECT_EQ(schema.accepts(less), reads(less)) << name << ": " << at / field.key();
      }
      json more = whole;
      more[at]["surprise"] = 1;
      EXPECT_FALSE(schema.accepts(more)) << name << ": " << at;
      EXPECT_FALSE(reads(more)) << name << ": " << at;
    }
    if (part.is_object() || part.is_array())
      for (const auto& inner : part.items()) visit(inner.value(), part.is_array() ? at / std::stoul(inner.key()) : at / inner.key());
  };
  visit(whole, json::json_pointer());
}

TEST(WordListSchema, AgreesWithTheReader) {
  const Schema schema("annotation.schema.json");
  const Reads reads = [](const json& list) { return wordListFromJson(list, "x", verbatim("x.json")).has_value(); };
  int files = 0;
  for (const auto& entry : fs::directory_iterator(kResources / "annotations")) {
    compare(schema, reads, documentOf(entry.path()), entry.path().filename().string());
    ++files;
  }
  EXPECT_EQ(files, 6);
}

TEST(BodyMarkSchema, AgreesWithTheReader) {
  const Schema schema("body-mark.schema.json");
  const fs::path folder = kResources / "body_marks";
  const Reads reads = [&](const json& mark) { return bodyMarkFromJson(mark, "x", folder, verbatim("x.json")).has_value(); };
  int files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    compare(schema, reads, documentOf(entry.path()), entry.path().filename().string());
    ++files;
  }
  EXPECT_GE(files, 9);
}

}  // namespace
}  // namespace ew::annotation::schema_test

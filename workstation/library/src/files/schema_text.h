#pragma once

namespace ew {

/// Text of resources/schemas/*.schema.json, put in by CMake.
extern const char* const kCaseSchemaText;
extern const char* const kPluginSchemaText;
extern const char* const kLessonsSchemaText;

}  // namespace ew

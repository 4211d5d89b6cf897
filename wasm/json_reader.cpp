#include "json_reader.h"

#include <cstring>

#include "json_memory.h"

#define RAPIDJSON_NAMESPACE rapidjson_library
#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

namespace txc {

JsonResult read_json(const char* text, std::size_t length, JsonEvents& events) {
    namespace json = rapidjson_library;
    // Iterative: a nested text takes no stack. Full precision: the nearest double, the same one on every machine.
    constexpr unsigned kFlags =
        json::kParseIterativeFlag | json::kParseFullPrecisionFlag | json::kParseValidateEncodingFlag;
    const std::size_t mark = length >= 3 && std::memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    json::MemoryStream stream(text + mark, length - mark);
    json::GenericReader<json::UTF8<>, json::UTF8<>, JsonMemory> reader;
    const json::ParseResult result = reader.Parse<kFlags>(stream, events);
    return {!result.IsError(), mark + result.Offset()};
}

}  // namespace txc

// A JSON text as a row of events. RapidJSON's parser stands behind this header, compiled once for all who listen.
#pragma once

#include <cstddef>
#include <cstdint>

namespace txc {

/// What a text holds, in its order. The names and meanings are RapidJSON's (its "handler"); false stops the reading.
/// Whole numbers come as the smallest of the four types that holds them, only negative ones as Int or Int64, but for -0;
/// what is beyond 64 bits, or is written with a point or an exponent, is a Double.
class JsonEvents {
public:
    virtual bool Null() = 0;
    virtual bool Bool(bool value) = 0;
    virtual bool Int(int value) = 0;
    virtual bool Uint(unsigned value) = 0;
    virtual bool Int64(std::int64_t value) = 0;
    virtual bool Uint64(std::uint64_t value) = 0;
    virtual bool Double(double value) = 0;
    /// UTF-8, with a zero behind it; the letters are there during the call. `copy` is true.
    virtual bool String(const char* letters, unsigned length, bool copy) = 0;
    virtual bool StartObject() = 0;
    virtual bool Key(const char* letters, unsigned length, bool copy) = 0;
    virtual bool EndObject(unsigned member_count) = 0;
    virtual bool StartArray() = 0;
    virtual bool EndArray(unsigned element_count) = 0;
    bool RawNumber(const char*, unsigned, bool) { return false; }  // asked for by flags that are not set

protected:
    ~JsonEvents() = default;
};

struct JsonResult {
    bool is_whole;      ///< the text is one JSON value, and no event said stop
    std::size_t place;  ///< where reading ended otherwise, bytes
};

/// Reads UTF-8 text, however deeply nested, in memory that grows with the nesting. Numbers are the nearest doubles.
JsonResult read_json(const char* text, std::size_t length, JsonEvents& events);

}  // namespace txc

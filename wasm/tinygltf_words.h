/// What tinygltf writes its messages with, in place of std::stringstream: that one brings all of <locale> along, money and
/// dates in two widths of characters, a quarter of the module's download. Include before tiny_gltf.h.
///
/// It works by name lookup: inside its own namespace, tinygltf's `std::` finds this namespace first, which holds all of ::std
/// and hides two names of it.
#pragma once

#include <ostream>
#include <string>

namespace tinygltf::std {

using namespace ::std;

class stringstream {
public:
    stringstream& operator<<(const char* words) {
        text_ += words;
        return *this;
    }
    stringstream& operator<<(const ::std::string& words) {
        text_ += words;
        return *this;
    }
    /// Whole numbers; tinygltf writes no others.
    template <typename Number>
    stringstream& operator<<(Number number) {
        text_ += ::std::to_string(number);
        return *this;
    }
    ::std::string str() const { return text_; }

private:
    ::std::string text_;
};

struct EndOfLine {};
constexpr EndOfLine endl{};

inline stringstream& operator<<(stringstream& stream, EndOfLine) { return stream << "\n"; }
inline ::std::ostream& operator<<(::std::ostream& stream, EndOfLine) { return stream.put('\n'); }

}  // namespace tinygltf::std

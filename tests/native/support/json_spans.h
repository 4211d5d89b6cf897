// Where the values of a JSON text begin and end, so that a test can put something else in their place.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace support {

struct JsonSpan {
    std::size_t begin;
    std::size_t end;           // one past the value
    std::size_t member_begin;  // of "key":value, where the value has a key; else begin
};

/// Every value of a valid JSON text without blanks between its tokens, the whole first, each before what it contains.
class JsonSpans {
public:
    explicit JsonSpans(const std::string& json) : json_(json) { read_value(0); }

    const std::vector<JsonSpan>& all() const { return spans_; }

private:
    void read_value(std::size_t member_begin) {
        const std::size_t place = spans_.size();
        spans_.push_back({at_, 0, member_begin});
        const char first = json_[at_];
        if (first == '{' || first == '[') {
            ++at_;
            while (json_[at_] != '}' && json_[at_] != ']') {
                const std::size_t begin = at_;
                if (first == '{') {
                    skip_string();
                    ++at_;  // the colon
                }
                read_value(begin);
                if (json_[at_] == ',') ++at_;
            }
            ++at_;
        } else if (first == '"') {
            skip_string();
        } else {
            while (at_ < json_.size() && json_[at_] != ',' && json_[at_] != '}' && json_[at_] != ']') ++at_;
        }
        spans_[place].end = at_;
    }
    void skip_string() {
        for (++at_; json_[at_] != '"'; ++at_) at_ += json_[at_] == '\\' ? 1 : 0;
        ++at_;
    }

    const std::string& json_;
    std::size_t at_ = 0;
    std::vector<JsonSpan> spans_;
};

}  // namespace support

#include "detail_words.h"

#include <cmath>

namespace txc {
namespace {

class Writer {
public:
    Writer(char* out, std::size_t size) : next_(out), last_(out + size - 1) {}

    void end() { *next_ = 0; }
    void letter(char c) {
        if (next_ < last_) *next_++ = c;
    }
    void letters(const char* text, std::size_t most) {
        for (std::size_t i = 0; i < most && text[i] != 0; ++i) letter(text[i]);
    }
    void whole(unsigned long long value) {
        char digits[20];
        int count = 0;
        do digits[count++] = static_cast<char>('0' + value % 10);
        while ((value /= 10) != 0);
        while (count > 0) letter(digits[--count]);
    }
    void signed_whole(long long value) {
        if (value < 0) letter('-');
        whole(value < 0 ? 0ull - static_cast<unsigned long long>(value) : static_cast<unsigned long long>(value));
    }

    void real(double value) {
        if (std::signbit(value)) letter('-');
        if (!std::isfinite(value)) return letters(std::isnan(value) ? "nan" : "inf", 3);
        double scaled = std::fabs(value);
        int exponent = scaled > 0.0 ? 5 : 0;  // of the first digit
        for (; scaled >= 1e6; ++exponent) scaled /= 10.0;
        for (; scaled > 0.0 && scaled < 1e5; --exponent) scaled *= 10.0;
        auto rounded = static_cast<int>(std::nearbyint(scaled));
        if (rounded == 1000000) {
            rounded = 100000;
            ++exponent;
        }
        char digits[6];
        int count = 0;  // without the zeros at the end
        for (int i = 5; i >= 0; --i, rounded /= 10) {
            digits[i] = static_cast<char>('0' + rounded % 10);
            if (count == 0 && (digits[i] != '0' || i == 0)) count = i + 1;
        }
        const bool is_plain = exponent >= -4 && exponent < 6;
        const int before_point = !is_plain ? 1 : exponent + 1;
        if (before_point <= 0) letter('0');
        for (int i = 0; i < before_point; ++i) letter(i < count ? digits[i] : '0');
        if (count > before_point) letter('.');
        for (int i = before_point; i < 0; ++i) letter('0');
        for (int i = before_point > 0 ? before_point : 0; i < count; ++i) letter(digits[i]);
        if (is_plain) return;
        letter('e');
        letter(exponent < 0 ? '-' : '+');
        const int size = exponent < 0 ? -exponent : exponent;
        if (size < 10) letter('0');
        whole(static_cast<unsigned long long>(size));
    }

private:
    char* next_;
    char* last_;
};

}  // namespace

void write_words(char* out, std::size_t size, const char* format, std::va_list arguments) {
    Writer writer(out, size);
    for (const char* at = format; *at != 0; ++at) {
        if (*at != '%') {
            writer.letter(*at);
            continue;
        }
        ++at;
        std::size_t most = static_cast<std::size_t>(-1);
        if (*at == '.') {
            for (most = 0; *++at >= '0' && *at <= '9';) most = most * 10 + static_cast<std::size_t>(*at - '0');
        }
        if (*at == 's') {
            writer.letters(va_arg(arguments, const char*), most);
        } else if (*at == 'c') {
            writer.letter(static_cast<char>(va_arg(arguments, int)));
        } else if (*at == 'd') {
            writer.signed_whole(va_arg(arguments, int));
        } else if (*at == 'u') {
            writer.whole(va_arg(arguments, unsigned));
        } else if (*at == 'g') {
            writer.real(va_arg(arguments, double));
        } else if (*at == 'z') {
            ++at;
            writer.whole(va_arg(arguments, std::size_t));
        } else if (*at == 'l') {
            at += 2;
            writer.whole(va_arg(arguments, unsigned long long));
        } else {
            writer.letter(*at);
        }
    }
    writer.end();
}

void write_words(char* out, std::size_t size, const char* format, ...) {
    std::va_list arguments;
    va_start(arguments, format);
    write_words(out, size, format, arguments);
    va_end(arguments);
}

}  // namespace txc

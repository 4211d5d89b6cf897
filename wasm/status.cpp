#include "status.h"

#include "detail_words.h"

namespace txc {

std::string& error_detail() {
    static std::string detail;
    return detail;
}

TxcStatus fail(TxcStatus status, const char* detail_format, ...) {
    char buffer[512];
    std::va_list arguments;
    va_start(arguments, detail_format);
    write_words(buffer, sizeof buffer, detail_format, arguments);
    va_end(arguments);
    error_detail() = buffer;
    return status;
}

}  // namespace txc

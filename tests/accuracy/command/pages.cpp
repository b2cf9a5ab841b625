#include "tests/accuracy/command/pages.hpp"

#include <cstdio>

#include "core/text.hpp"

namespace plumb::accuracy {

namespace {

constexpr std::string_view kStyle =
    "body{font:15px system-ui,sans-serif;margin:2rem;max-width:90rem;color:#1d2433;background:#fff}"
    "table{border-collapse:collapse;margin:1rem 0}td,th{border:1px solid #cbd2dd;padding:.3rem .5rem;"
    "text-align:left;font-size:13px;vertical-align:top}td.bad{background:#f9d3cc}td.good{background:#dff2df}"
    "@media(prefers-color-scheme:dark){body{color:#e6e9ef;background:#161a22}td,th{border-color:#3a4353}"
    "td.bad{background:#6b2a22}td.good{background:#234a2a}}";

}  // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&': safe += "&amp;"; break;
            case '<': safe += "&lt;"; break;
            case '>': safe += "&gt;"; break;
            case '"': safe += "&quot;"; break;
            case '\'': safe += "&#39;"; break;
            default: safe += c;
        }
    }
    return safe;
}

std::string quotedForJson(std::string_view value) {
    std::string result = "\"";
    for (const char c : value) {
        if (c == '"' || c == '\\') result += '\\';
        if (static_cast<unsigned char>(c) >= 0x20) result += c;
    }
    return result + "\"";
}

std::string tablePage(std::string_view title, std::string_view body) {
    return format(
        "<!doctype html><html lang=\"en\"><meta "
        "charset=\"utf-8\"><title>{}</title><style>{}</style><h1>{}</h1>"
        "{}</html>\n",
        escaped(title), kStyle, escaped(title), body);
}

bool write(const Path& path, std::string_view text) {
    const auto written = writeFile(path, text);
    if (!written) std::fprintf(stderr, "%s\n", written.error().text().c_str());
    return written.ok();
}

}  // namespace plumb::accuracy

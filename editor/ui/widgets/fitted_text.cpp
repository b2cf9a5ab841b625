#include "editor/ui/widgets/fitted_text.hpp"

#include <vector>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kLeftOut = "\xe2\x80\xa6";

float widthOf(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

/// Returns the byte index of each code point of a UTF-8 text, and the length of the text.
std::vector<std::size_t> lettersOf(const std::string& text) {
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if ((static_cast<unsigned char>(text[i]) & 0xc0u) != 0x80u) at.push_back(i);
    }
    at.push_back(text.size());
    return at;
}

/// Returns the text shortened to this many letters; the larger half is taken from the end.
std::string withLetters(const std::string& text, const std::vector<std::size_t>& at, std::size_t kept) {
    const std::size_t head = kept / 2;
    const std::size_t tail = at.size() - 1 - (kept - head);
    return text.substr(0, at[head]) + kLeftOut + text.substr(at[tail]);
}

}  // namespace

std::string fittedText(const std::string& text, float width) {
    if (widthOf(text) <= width) return text;
    const std::vector<std::size_t> at = lettersOf(text);
    std::size_t fits = 0;
    std::size_t none = at.size() - 1;
    while (fits + 1 < none) {
        const std::size_t half = (fits + none) / 2;
        (widthOf(withLetters(text, at, half)) <= width ? fits : none) = half;
    }
    return fits == 0 ? std::string{} : withLetters(text, at, fits);
}

void fittedLine(const std::string& text, float width) {
    const std::string fitted = fittedText(text, width);
    ImGui::TextUnformatted(fitted.c_str());
    if (fitted != text) tooltip(text);
}

}  // namespace plumb::editor::ui

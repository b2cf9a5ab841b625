#include "import/loaders/xml.hpp"

#include <expat.h>
#include <memory>
#include <optional>
#include <type_traits>

#include "core/limits.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::size_t kAttributes = 256;  // maximum number in one element

/// Builds the tree of elements from the callbacks of expat. No exception may pass through expat, which is C:
/// the callbacks only append, and a lack of memory ends the program, as in the rest of the engine.
class TreeBuilder {
public:
    TreeBuilder(XML_Parser parser, std::string_view where) : parser_{parser}, where_{where} {
        XML_SetUserData(parser, this);
        XML_SetElementHandler(parser, onStart, onEnd);
        XML_SetCharacterDataHandler(parser, onText);
        XML_SetStartDoctypeDeclHandler(parser, onDoctype);
        XML_SetSkippedEntityHandler(parser, onSkippedEntity);
    }

    Result<XmlElement> build(std::string_view document) {
        if (document.size() > limits::kFileBytes) fail("the file is too large", "split it");
        const bool parsed = !error_ && XML_Parse(parser_, document.data(), static_cast<int>(document.size()),
                                                 XML_TRUE) == XML_STATUS_OK;
        if (error_) return *std::move(error_);
        if (!parsed) {
            fail(XML_ErrorString(XML_GetErrorCode(parser_)), "correct the line, or export the file again");
            return *std::move(error_);
        }
        return std::move(root_);
    }

private:
    static TreeBuilder& self(void* user) { return *static_cast<TreeBuilder*>(user); }
    static void onStart(void* user, const XML_Char* name, const XML_Char** attributes) {
        self(user).start(name, attributes);
    }
    static void onEnd(void* user, const XML_Char*) {
        if (!self(user).open_.empty()) self(user).open_.pop_back();
    }
    static void onText(void* user, const XML_Char* text, int length) {
        if (!self(user).open_.empty())
            self(user).open_.back()->text.append(text, static_cast<std::size_t>(length));
    }
    static void onDoctype(void* user, const XML_Char*, const XML_Char*, const XML_Char*,
                          int hasDeclarations) {
        if (hasDeclarations != 0)
            self(user).fail("a DOCTYPE with declarations is not supported", "remove it");
    }
    static void onSkippedEntity(void* user, const XML_Char* name, int) {
        self(user).fail(format("the entity &{}; is unknown", name), "write the character itself");
    }

    void start(const XML_Char* name, const XML_Char** attributes) {
        if (error_) return;
        if (open_.size() >= static_cast<std::size_t>(limits::kXmlDepth))
            return fail("elements are nested too deep", "reduce the nesting");
        if (++elements_ > limits::kXmlElements)
            return fail("too many elements", "split the file, or use csv data");
        // Only the innermost open element gets children, so the addresses of the open ones stay.
        XmlElement& element = open_.empty() ? root_ : open_.back()->children.emplace_back();
        element.name = name;
        element.line = line();
        for (; *attributes != nullptr; attributes += 2) {
            if (element.attributes.size() >= kAttributes) return fail("too many attributes", "remove some");
            element.attributes.push_back({attributes[0], attributes[1]});
        }
        open_.push_back(&element);
    }

    /// Ends the parse. Only the first error is kept.
    void fail(std::string what, std::string remedy) {
        if (error_) return;
        error_ = Error{format("{}:{}", where_, line()), std::move(what), std::move(remedy)};
        XML_StopParser(parser_, XML_FALSE);
    }

    [[nodiscard]] int line() const { return static_cast<int>(XML_GetCurrentLineNumber(parser_)); }

    XML_Parser parser_;
    std::string_view where_;
    XmlElement root_;
    std::vector<XmlElement*> open_;  ///< open elements, from the root to the innermost
    std::size_t elements_ = 0;
    std::optional<Error> error_;
};

}  // namespace

const std::string* XmlElement::find(std::string_view attribute) const {
    for (const XmlAttribute& candidate : attributes) {
        if (candidate.name == attribute) return &candidate.value;
    }
    return nullptr;
}

const XmlElement* XmlElement::child(std::string_view element) const {
    for (const XmlElement& candidate : children) {
        if (candidate.name == element) return &candidate;
    }
    return nullptr;
}

Result<XmlElement> parseXml(std::string_view document, std::string_view where) {
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser{
        XML_ParserCreate(nullptr), XML_ParserFree};
    if (!parser) return Error{std::string{where}, "not enough memory to read the file", "close programs"};
    return TreeBuilder{parser.get(), where}.build(document);
}

}  // namespace plumb

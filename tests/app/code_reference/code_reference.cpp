#include "tests/app/code_reference/code_reference.hpp"

#include <algorithm>
#include <regex>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/text.hpp"
#include "tests/app/code_reference/header_reader.hpp"
#include "tests/support/places.hpp"

namespace plumb::test {
namespace {

/// What the reference takes from a header.
struct Source {
    const char* header;              ///< below engine/
    std::vector<const char*> names;  ///< empty: everything
};
struct Chapter {
    const char* title;
    std::vector<Source> sources;
};

const std::vector<Chapter>& chapters() {
    static const std::vector<Chapter> all{
        {"Functions for systems",
         {{"gameplay/game_functions.hpp", {}},
          {"gameplay/harm.hpp", {}},
          {"scene/scene_stack.hpp", {"inputFor"}}}},
        {"Timers and gradual changes",
         {{"gameplay/delayed_events.hpp", {"DelayedEvent", "emitAfter", "cancel", "ticksOf"}},
          {"gameplay/tweens.hpp", {"TweenEnded", "tween", "stopTweens"}},
          {"math/easing.hpp", {}}}},
        {"Contacts and queries",
         {{"scene/physics/contact_events.hpp", {}},
          {"gameplay/touches.hpp", {}},
          {"scene/physics/physics_queries.hpp", {}}}},
        {"Positions and families",
         {{"scene/components/transform.hpp", {"teleport"}},
          {"scene/world_transform.hpp", {"Pose", "worldPose"}},
          {"ecs/hierarchy.hpp", {"setParent", "parentOf", "isAncestor", "childrenOf"}}}},
        {"Other events and resources",
         {{"scene/systems/animation_system.hpp", {"AnimationFrameBegan"}},
          {"scene/play_sound.hpp", {"PlaySound"}},
          {"gameplay/game_progress.hpp", {"GameProgress", "fillPlaceholders"}},
          {"gameplay/label_values.hpp", {"LabelValues"}},
          {"scene/drawing/background.hpp", {"Background"}}}},
        {"Code of a project",
         {{"app/module.hpp", {"Module", "before", "after"}},
          {"reflect/type_builder.hpp", {"TypeBuilder", "FieldBuilder"}},
          {"reflect/type_info.hpp", {"Unit", "EnumName"}},
          {"core/fixed_list.hpp", {}},
          {"reflect/field_types.hpp", {"AssetRef"}}}},
        {"A game in code",
         {{"app/engine.hpp", {}}, {"app/game.hpp", {}}, {"app/screen_settings.hpp", {"ScreenSettings"}}}},
        {"World and entities",
         {{"ecs/world.hpp", {}}, {"ecs/entity.hpp", {}}, {"ecs/query.hpp", {"with", "without", "Query"}}}},
        {"Input", {{"input/input.hpp", {}}, {"input/action.hpp", {"Action", "Axis"}}}},
        {"Assets", {{"assets/asset_store.hpp", {"AssetStore"}}}},
        {"Numbers, colors and texts",
         {{"math/vec2.hpp", {}},
          {"math/angle.hpp", {}},
          {"math/rect.hpp", {}},
          {"math/color.hpp", {}},
          {"core/random.hpp", {}},
          {"core/text.hpp", {"format", "fixedText"}},
          {"core/log.hpp", {"logNote", "logWarning", "logError"}}}},
        {"Fields that components inherit",
         {{"scene/collider_surface.hpp", {"ColliderSurface"}},
          {"scene/joint_link.hpp", {"JointLink", "JointStiffness"}},
          {"scene/field_region.hpp", {"FieldRegion"}},
          {"scene/soft_look.hpp", {"SoftLook"}}}},
    };
    return all;
}

std::vector<Declaration> declarationsOf(const std::string& header) {
    return readHeader(*readFile(sourceFolder() / "engine" / header));
}

/// The headers of components that a list of them includes, in its order.
std::vector<std::string> includedBy(const char* header) {
    const std::string text = *readFile(sourceFolder() / "engine" / header);
    static const std::regex kInclude{"#include \"([a-z_/]*/components/[a-z_/]*\\.hpp)\""};
    std::vector<std::string> headers;
    for (std::sregex_iterator at{text.begin(), text.end(), kInclude}, end; at != end; ++at)
        headers.push_back((*at)[1]);
    return headers;
}

std::string withStop(std::string text) {
    if (!text.empty() && text.find_last_of(".!?:") != text.size() - 1) text += '.';
    return text;
}

/// A comment as a sentence: parameters and results in words.
std::string sentenceOf(const std::string& doc) {
    struct Word {
        const char* tag;
        const char* text;
    };
    static constexpr Word kWords[] = {{"@return ", "Returns "}, {"@error ", "Error: "}, {"@pre ", "Needs: "}};
    std::string sentence;
    for (std::size_t start = 0; start < doc.size();) {
        const std::size_t end = std::min(doc.find(" @", start + 1), doc.size());
        std::string part{trimmed(doc.substr(start, end - start))};
        static const std::regex kParameter{"^@t?param ((?:\\w+, )*\\w+)\\s+"};
        part = std::regex_replace(part, kParameter, "`$1`: ");
        for (const Word& word : kWords) {
            const std::size_t size = std::string_view{word.tag}.size();
            if (startsWith(part, word.tag)) part = word.text + std::string{trimmed(part.substr(size))};
        }
        sentence += (sentence.empty() ? "" : " ") + withStop(part);
        start = end + (end < doc.size() ? 1 : 0);
    }
    return sentence;
}

std::string described(const Declaration& declaration) {
    const std::string words = sentenceOf(declaration.doc);
    return format("`{}`{}{}", declaration.signature, words.empty() ? "" : ": ", words);
}

/// One line for each variable and function; overloads with one comment share a line.
std::string linesOf(const std::vector<Declaration>& declarations) {
    std::string text;
    for (std::size_t i = 0; i < declarations.size(); ++i) {
        Declaration shown = declarations[i];
        if (shown.isType) continue;
        const auto isOverload = [&](const Declaration& next) {
            return next.continues && next.isFunction && next.name == shown.name;
        };
        while (i + 1 < declarations.size() && isOverload(declarations[i + 1]))
            shown.signature += "`, `" + declarations[++i].signature;
        text += "- " + described(shown) + "\n";
    }
    return text;
}

std::string enumOf(const Declaration& type) {
    std::string names;
    for (const Declaration& value : type.members) names += (names.empty() ? "" : ", ") + value.name;
    return format("- {}{}{}.\n", described(type), type.doc.empty() ? ": " : " ", names);
}

std::string typeOf(const Declaration& type) {
    if (startsWith(type.signature, "enum")) return enumOf(type);
    return format("\n### {}\n\n{}\n\n{}\n", type.name, described(type), linesOf(type.members));
}

bool isWanted(const Source& source, const Declaration& declaration) {
    const auto isName = [&](const char* name) { return declaration.name == name; };
    return source.names.empty() || std::any_of(source.names.begin(), source.names.end(), isName);
}

std::string chapterOf(const Chapter& chapter, std::string& missing) {
    std::vector<Declaration> functions;
    std::string types;
    std::string enums;
    for (const Source& source : chapter.sources) {
        const std::vector<Declaration> all = declarationsOf(source.header);
        for (const char* name : source.names) {
            const auto isName = [&](const Declaration& made) { return made.name == name; };
            if (std::none_of(all.begin(), all.end(), isName))
                missing += format("{} is not in {}\n", name, source.header);
        }
        for (const Declaration& made : all) {
            if (!isWanted(source, made)) continue;
            if (!made.isType) {
                functions.push_back(made);
            } else {
                (startsWith(made.signature, "enum") ? enums : types) += typeOf(made);
            }
        }
    }
    return format("\n## {}\n\n{}{}{}", chapter.title, linesOf(functions), enums, types);
}

std::string componentsOf(const char* title, const char* list) {
    std::string text = format("\n## {}\n", title);
    for (const std::string& header : includedBy(list)) {
        std::string enums;
        std::string types;
        for (const Declaration& made : declarationsOf(header)) {
            if (!made.isType) continue;
            (startsWith(made.signature, "enum") ? enums : types) += typeOf(made);
        }
        text += types + enums;
    }
    return text;
}

constexpr const char* kHead = R"(# Reference of the C++ code

Made from the comments of the headers by the test `CodeReference.isMadeFromTheHeaders`. [Code of a project](code.md) and
[a game in code](code-games.md) explain how these belong together. All are in the namespace `plumb`; `#include <plumb.hpp>` includes them.

Units are given with each value: px, s, rad, kg; y points down, angles grow clockwise. Ratios are 0..1.
)";

}  // namespace

std::string codeReference(std::string& missing) {
    std::string text = kHead;
    for (const Chapter& chapter : chapters()) text += chapterOf(chapter, missing);
    text += componentsOf("Components", "scene/components.hpp");
    text += componentsOf("Components of gameplay", "gameplay/components.hpp");
    // No empty lines in a row.
    return std::regex_replace(text, std::regex{"\n\n\n+"}, "\n\n");
}

}  // namespace plumb::test

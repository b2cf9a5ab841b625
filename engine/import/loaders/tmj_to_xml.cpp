#include "import/loaders/tmj_to_xml.hpp"

#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

/// XML names for an array member of a JSON object: of the enclosing element (may be ""), and of each item.
struct ListRule {
    std::string_view key;
    std::string_view parent;
    std::string_view item;
};
constexpr ListRule kLists[] = {
    {"tilesets", "", "tileset"},         {"tiles", "", "tile"},
    {"objects", "", "object"},           {"animation", "animation", "frame"},
    {"wangsets", "wangsets", "wangset"}, {"colors", "", "wangcolor"},
    {"wangtiles", "", "wangtile"},       {"terrains", "terraintypes", "terrain"},
};
constexpr std::string_view kChildObjects[] = {"tileoffset",      "grid",    "objectgroup",
                                              "transformations", "tileset", "object"};
constexpr std::string_view kMarks[] = {"ellipse", "point", "capsule"};  // empty elements; flags in JSON
constexpr std::pair<std::string_view, std::string_view> kLayerElements[] = {
    {"tilelayer", "layer"}, {"objectgroup", "objectgroup"}, {"imagelayer", "imagelayer"}, {"group", "group"}};

template <class List>
bool isIn(std::string_view word, const List& list) {
    for (const std::string_view candidate : list) {
        if (candidate == word) return true;
    }
    return false;
}

std::string scalarText(const Json& value) {
    if (const std::string* text = jsonText(value)) return *text;
    if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
    if (value.is_number_integer()) return compactText(value);
    if (value.is_number()) return shortestText(value.get<double>());
    return {};
}

std::string memberText(const Json& object, std::string_view key) {
    const Json* found = findMember(object, key);
    return found == nullptr ? std::string{} : scalarText(*found);
}

void addAttribute(XmlElement& element, std::string_view name, std::string value) {
    element.attributes.push_back({std::string{name}, std::move(value)});
}

XmlElement& addChild(XmlElement& element, std::string_view name) {
    XmlElement& child = element.children.emplace_back();
    child.name = name;
    return child;
}

std::string numberList(const Json& list) {
    std::string text;
    for (const Json& number : list) {
        if (!text.empty()) text += ',';
        text += scalarText(number);
    }
    return text;
}

void addProperty(XmlElement& property, const Json& value, std::string_view type);

/// Adds the members of a class written as an object, {"a": 1}; their types follow from the JSON values.
void addMembers(XmlElement& element, const Json& object) {
    XmlElement& properties = addChild(element, "properties");
    for (const auto& [key, value] : object.items()) {
        XmlElement& property = addChild(properties, "property");
        addAttribute(property, "name", key);
        addProperty(property, value, "");
    }
}

void addProperty(XmlElement& property, const Json& value, std::string_view type) {
    if (value.is_object()) {
        addAttribute(property, "type", "class");
        addMembers(property, value);
    } else if (value.is_array()) {
        addAttribute(property, "type", "list");
        for (const Json& item : value) {
            const Json* wrapped = findMember(item, "value");
            addProperty(addChild(property, "item"), wrapped != nullptr ? *wrapped : item,
                        wrapped != nullptr ? memberText(item, "type") : std::string{});
        }
    } else {
        const std::string_view found = value.is_boolean()          ? "bool"
                                       : value.is_number_integer() ? "int"
                                       : value.is_number()         ? "float"
                                                                   : "string";
        addAttribute(property, "type", std::string{type.empty() ? found : type});
        addAttribute(property, "value",
                     value.is_boolean() ? (value.get<bool>() ? "true" : "false") : scalarText(value));
    }
}

void addProperties(XmlElement& element, const Json& list) {
    XmlElement& properties = addChild(element, "properties");
    if (list.is_object()) {  // the format before Tiled 1.2
        for (const auto& [key, value] : list.items()) {
            XmlElement& property = addChild(properties, "property");
            addAttribute(property, "name", key);
            addProperty(property, value, "");
        }
        return;
    }
    for (const Json& item : list) {
        if (!item.is_object()) continue;
        XmlElement& property = addChild(properties, "property");
        addAttribute(property, "name", memberText(item, "name"));
        addAttribute(property, "propertytype", memberText(item, "propertytype"));
        const auto value = item.find("value");
        if (value != item.end()) addProperty(property, *value, memberText(item, "type"));
    }
}

void addPoints(XmlElement& element, std::string_view name, const Json& points) {
    std::string text;
    for (const Json& point : points) {
        if (!point.is_object()) continue;
        if (!text.empty()) text += ' ';
        text += memberText(point, "x") + ',' + memberText(point, "y");
    }
    addAttribute(addChild(element, name), "points", text);
}

void fillData(XmlElement& element, const Json& data, const Json& owner) {
    if (const std::string* text = jsonText(data)) {
        addAttribute(element, "encoding", memberText(owner, "encoding"));
        addAttribute(element, "compression", memberText(owner, "compression"));
        element.text = *text;
    } else {
        addAttribute(element, "encoding", "csv");
        element.text = numberList(data);
    }
}

void addChunks(XmlElement& layer, const Json& chunks, const Json& owner) {
    XmlElement& data = addChild(layer, "data");
    for (const Json& chunk : chunks) {
        const Json* cells = findMember(chunk, "data");
        if (cells == nullptr) continue;
        XmlElement& element = addChild(data, "chunk");
        for (const std::string_view key : {"x", "y", "width", "height"})
            addAttribute(element, key, memberText(chunk, key));
        fillData(element, *cells, owner);
    }
    const Json* cells = chunks.empty() ? nullptr : findMember(*chunks.begin(), "data");
    const bool isText = cells != nullptr && !cells->is_array();
    addAttribute(data, "encoding", isText ? memberText(owner, "encoding") : std::string{"csv"});
    addAttribute(data, "compression", memberText(owner, "compression"));
}

/// Recursion depth is limited, because the JSON reader limits nesting.
void fill(XmlElement& element, const Json& object);

void addImage(XmlElement& element, const Json& object) {
    XmlElement& image = addChild(element, "image");
    addAttribute(image, "source", memberText(object, "image"));
    addAttribute(image, "width", memberText(object, "imagewidth"));
    addAttribute(image, "height", memberText(object, "imageheight"));
    addAttribute(image, "trans", memberText(object, "transparentcolor"));
}

void addLayers(XmlElement& element, const Json& layers) {
    for (const Json& layer : layers) {
        if (!layer.is_object()) continue;
        const std::string type = memberText(layer, "type");
        for (const auto& [kind, name] : kLayerElements) {
            if (kind == type) fill(addChild(element, name), layer);
        }
    }
}

bool addKnownMember(XmlElement& element, const std::string& key, const Json& value, const Json& object) {
    for (const ListRule& rule : kLists) {
        if (rule.key != key || !value.is_array()) continue;
        XmlElement& parent = rule.parent.empty() ? element : addChild(element, rule.parent);
        for (const Json& item : value) {
            if (item.is_object()) fill(addChild(parent, rule.item), item);
        }
        return true;
    }
    if (key == "layers") return addLayers(element, value), true;
    if (key == "properties") return addProperties(element, value), true;
    if (key == "data") return fillData(addChild(element, "data"), value, object), true;
    if (key == "chunks" && value.is_array()) return addChunks(element, value, object), true;
    if (key == "image") return addImage(element, object), true;
    if (key == "polygon" || key == "polyline") return addPoints(element, key, value), true;
    if (key == "wangid" && value.is_array()) return addAttribute(element, key, numberList(value)), true;
    if (isIn(key, kMarks)) {
        if (value.is_boolean() && value.get<bool>()) addChild(element, key);
        return true;
    }
    if (key == "text" && value.is_object()) {
        XmlElement& text = addChild(element, key);
        fill(text, value);
        text.text = memberText(value, "text");
        return true;
    }
    if (!isIn(key, kChildObjects) || !value.is_object()) return false;
    fill(addChild(element, key), value);
    return true;
}

void fill(XmlElement& element, const Json& object) {
    for (const auto& [key, value] : object.items()) {
        if (addKnownMember(element, key, value, object)) continue;
        if (value.is_null()) continue;
        if (value.is_primitive()) {
            addAttribute(element, key, scalarText(value));
        } else if (key == "terrain" && value.is_array()) {
            addAttribute(element, key, numberList(value));
        } else {
            addChild(element, key);  // the reader of the elements reports it as unknown
        }
    }
}

}  // namespace

Result<XmlElement> tmjToXml(std::string_view text, std::string_view element, std::string_view where) {
    std::vector<Error> repeatedKeys;
    const Result<Json> json = parseJson(text, where, &repeatedKeys);
    if (!json) return json.error();
    if (!json->is_object())
        return Error{std::string{where}, "not a Tiled file", "export it from Tiled again"};
    XmlElement root;
    root.name = element;
    fill(root, *json);
    return root;
}

}  // namespace plumb

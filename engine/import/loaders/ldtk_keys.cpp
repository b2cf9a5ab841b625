#include "import/loaders/ldtk_keys.hpp"

#include <utility>

#include "core/text.hpp"
#include "import/loaders/word_list.hpp"
#include "reflect/json.hpp"

namespace plumb {
namespace {

/// The known keys of one kind of JSON object in LDtk files.
struct Kind {
    std::string_view name;
    std::string_view read;     ///< keys that are imported, separated by spaces
    std::string_view ignored;  ///< keys that only LDtk uses, separated by spaces
    std::string_view inner;    ///< "key:kind": members to check, and the Kind of their objects
};

// Source: LDtk, "JSON format documentation", version 1.5.3.
constexpr Kind kKinds[] = {
    {"project", "iid jsonVersion bgColor worldLayout defs levels worlds toc externalLevels",
     "__header__ __FORCED_REFS appBuildId nextUid identifierStyle worldGridWidth worldGridHeight "
     "defaultLevelWidth defaultLevelHeight defaultPivotX defaultPivotY defaultGridSize defaultEntityWidth "
     "defaultEntityHeight defaultLevelBgColor minifyJson exportTiled simplifiedExport imageExportMode "
     "exportLevelBg exportPng pngFilePattern backupOnSave backupLimit backupRelPath levelNamePattern "
     "tutorialDesc customCommands flags dummyWorldIid",
     "defs:defs levels:level worlds:world"},
    {"defs", "layers entities tilesets enums externalEnums levelFields", "",
     "layers:layerDef entities:entityDef tilesets:tilesetDef"},
    {"layerDef",
     "__type identifier type uid gridSize parallaxFactorX parallaxFactorY parallaxScaling intGridValues "
     "autoRuleGroups tilesetDefUid autoSourceLayerDefUid",
     "doc uiColor guideGridWid guideGridHei displayOpacity inactiveOpacity hideInList hideFieldsWhenInactive "
     "canSelectWhenInactive renderInWorldView pxOffsetX pxOffsetY requiredTags excludedTags "
     "autoTilesKilledByOtherLayerUid uiFilterTags useAsyncRender intGridValuesGroups "
     "autoTilesetDefUid tilePivotX tilePivotY biomeFieldUid",
     "intGridValues:intGridValue"},
    {"intGridValue", "value identifier color", "tile groupUid", ""},
    {"entityDef",
     "identifier uid resizableX resizableY color renderMode tileRenderMode tileOpacity tileRect tilesetId",
     "tags exportToToc allowOutOfBounds doc width height minWidth maxWidth minHeight maxHeight "
     "keepAspectRatio fillOpacity lineOpacity hollow showName uiTileRect nineSliceBorders maxCount "
     "limitScope "
     "limitBehavior pivotX pivotY fieldDefs tileId",
     ""},
    {"tilesetDef",
     "identifier uid relPath embedAtlas pxWid pxHei tileGridSize spacing padding tags enumTags customData "
     "tagsSourceEnumUid",
     "__cWid __cHei savedSelections cachedPixelData", ""},
    {"world", "iid identifier worldLayout levels",
     "worldGridWidth worldGridHeight defaultLevelWidth defaultLevelHeight", "levels:level"},
    {"level",
     "identifier iid worldX worldY worldDepth pxWid pxHei __bgColor bgColor bgRelPath __bgPos "
     "externalRelPath "
     "fieldInstances layerInstances",
     "__header__ uid useAutoIdentifier bgPos bgPivotX bgPivotY __smartColor __neighbours",
     "fieldInstances:field layerInstances:layer"},
    {"layer",
     "__identifier __type __cWid __cHei __gridSize __opacity __pxTotalOffsetX __pxTotalOffsetY "
     "__tilesetDefUid iid layerDefUid visible intGridCsv intGrid autoLayerTiles overrideTilesetUid gridTiles "
     "entityInstances",
     "__tilesetRelPath levelId pxOffsetX pxOffsetY optionalRules seed",
     "autoLayerTiles:tile gridTiles:tile entityInstances:entity"},
    {"tile", "px src f t a", "d", ""},
    {"entity", "__identifier __pivot __tags __tile __smartColor iid width height defUid px fieldInstances",
     "__grid __worldX __worldY", "fieldInstances:field"},
    {"field", "__identifier __type __value", "__tile defUid realEditorValues", ""},
};

const Kind* kindOf(std::string_view name) {
    for (const Kind& kind : kKinds) {
        if (kind.name == name) return &kind;
    }
    return nullptr;
}

const Kind* innerKind(const Kind& kind, std::string_view key) {
    for (const std::string_view pair : split(kind.inner, ' ')) {
        const std::size_t colon = pair.find(':');
        if (colon != std::string_view::npos && pair.substr(0, colon) == key)
            return kindOf(pair.substr(colon + 1));
    }
    return nullptr;
}

class Walk {
public:
    Walk(std::string_view where, std::set<std::string>& editorKeys, std::vector<Error>& problems)
        : where_{where}, editorKeys_{editorKeys}, problems_{problems} {}

    void look(const Json& json, const Kind& kind) {
        if (json.is_array()) {
            for (const Json& item : json) look(item, kind);
            return;
        }
        if (!json.is_object()) return;
        for (const auto& [key, value] : json.items()) {
            if (hasWord(kind.read, key)) {
                if (const Kind* inner = innerKind(kind, key)) look(value, *inner);
            } else if (hasWord(kind.ignored, key)) {
                editorKeys_.insert(key);
            } else if (reported_.insert(format("{}.{}", kind.name, key)).second) {
                problems_.push_back({format("{}: {}", where_, kind.name),
                                     format("the key \"{}\" is unknown and was ignored", key),
                                     "no action is needed if the levels look right"});
            }
        }
    }

private:
    std::string_view where_;
    std::set<std::string>& editorKeys_;
    std::vector<Error>& problems_;
    std::set<std::string> reported_;
};

}  // namespace

void reportUnknownKeys(const Json& project, std::string_view where, std::set<std::string>& editorKeys,
                       std::vector<Error>& problems) {
    Walk{where, editorKeys, problems}.look(project, *kindOf("project"));
}

void reportUnknownLevelKeys(const Json& level, std::string_view where, std::set<std::string>& editorKeys,
                            std::vector<Error>& problems) {
    Walk{where, editorKeys, problems}.look(level, *kindOf("level"));
}

}  // namespace plumb

#include "import/loaders/tmx_elements.hpp"

#include "import/loaders/word_list.hpp"

namespace plumb {
namespace {

// Source: Tiled, "TMX Map Format" and "JSON Map Format", version 1.12. In the JSON format some attributes are
// one level higher (a layer's encoding), and lists have a length attribute.
constexpr TmxElement kElements[] = {
    {"map",
     "version class orientation renderorder width height tilewidth tileheight parallaxoriginx "
     "parallaxoriginy "
     "backgroundcolor infinite hexsidelength staggeraxis staggerindex",
     "tiledversion compressionlevel nextlayerid nextobjectid type"},
    {"editorsettings", "", "", true},
    {"export", "", "", true},
    {"tileset",
     "firstgid source name class tilewidth tileheight spacing margin tilecount columns objectalignment "
     "tilerendersize fillmode backgroundcolor image imagewidth imageheight transparentcolor",
     "version tiledversion type"},
    {"tileoffset", "x y"},
    {"grid", "orientation width height"},
    {"transformations", "hflip vflip rotate preferuntransformed"},
    {"image", "source trans width height", "format id"},
    {"terraintypes", ""},
    {"terrain", "name tile"},
    {"tile",
     "id type class terrain probability x y width height gid image imagewidth imageheight transparentcolor"},
    {"animation", ""},
    {"frame", "tileid duration"},
    {"wangsets", ""},
    {"wangset", "name class type tile"},
    {"wangcolor", "name class color tile probability"},
    {"wangcornercolor", "name color tile probability"},
    {"wangedgecolor", "name color tile probability"},
    {"wangtile", "tileid wangid", "hflip vflip dflip"},
    {"layer",
     "id name class width height opacity visible locked tintcolor offsetx offsety parallaxx parallaxy mode "
     "encoding compression type",
     "x y startx starty"},
    {"data", "encoding compression"},
    {"chunk", "x y width height encoding compression"},
    {"objectgroup",
     "id name class color opacity visible locked tintcolor offsetx offsety parallaxx parallaxy draworder "
     "mode "
     "type",
     "x y width height"},
    {"object", "id name type class x y width height rotation gid visible opacity template"},
    {"ellipse", ""},
    {"point", ""},
    {"capsule", ""},
    {"polygon", "points"},
    {"polyline", "points"},
    {"text", "text fontfamily pixelsize wrap color bold italic underline strikeout kerning halign valign"},
    {"imagelayer",
     "id name class x y offsetx offsety opacity visible locked tintcolor parallaxx parallaxy repeatx repeaty "
     "mode image imagewidth imageheight transparentcolor type",
     "width height"},
    {"group", "id name class offsetx offsety opacity visible locked tintcolor parallaxx parallaxy mode type",
     "x y width height"},
    {"properties", ""},
    {"property", "name type propertytype value"},
    {"item", "type propertytype value"},
    {"template", "", "type version tiledversion"},
};

}  // namespace

bool TmxElement::reads(std::string_view attribute) const { return hasWord(read, attribute); }
bool TmxElement::isEditorOnly(std::string_view attribute) const {
    return editorOnly || hasWord(ignored, attribute);
}

const TmxElement* findTmxElement(std::string_view name) {
    for (const TmxElement& element : kElements) {
        if (element.name == name) return &element;
    }
    return nullptr;
}

}  // namespace plumb

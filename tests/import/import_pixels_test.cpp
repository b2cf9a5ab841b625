// Compares imported Tiled maps, drawn by the engine's renderer, with the images that Tiled's `tmxrasterizer`
// draws of the maps.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "import/import_file.hpp"
#include "import/loaders/tmx_loader.hpp"
#include "import/map_lattice.hpp"
#include "import/orthogonal_form.hpp"
#include "platform/image_file.hpp"
#include "platform/window.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "reflect/type_registry.hpp"
#include "render/gl/gl_device.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/register_components.hpp"
#include "tests/support/foreign_maps.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

constexpr Vec2 kPicture{320.0f, 180.0f};
constexpr int kTolerance = 12;        // maximum difference per channel, 0 to 255: filters round differently
constexpr double kEnough = 0.99;      // minimum ratio of equal pixels outside the mask
constexpr double kOwnEnough = 0.999;  // of maps that the tests write
constexpr int kAround = 3;            // px: margin of areas not compared, since Tiled's outlines are wide

bool canRasterize() { return std::system("command -v tmxrasterizer > /dev/null 2>&1") == 0; }

/// Draws a map with tmxrasterizer; no value if it fails.
std::optional<Image> rasterized(const Path& map, const Path& folder) {
    const Path png = folder / "tiled.png";
    const std::string command =
        format("QT_QPA_PLATFORM=offscreen tmxrasterizer --no-smoothing '{}' '{}' > /dev/null 2>&1",
               map.generic_string(), png.generic_string());
    if (std::system(command.c_str()) != 0) return {};
    const Result<std::string> bytes = readFile(png);
    const Result<Image> image = bytes ? decodeImage(*bytes, "tiled.png") : Result<Image>{bytes.error()};
    return image ? std::optional{*image} : std::nullopt;
}

/// Copies the folder of a map and unpacks its files, because tmxrasterizer cannot read files that Debian
/// compressed with gzip.
Path unpackedCopy(const Path& map, const Path& folder) {
    const Path around = map.lexically_normal().parent_path();  // rule maps are one folder below their images
    const std::string copy = (folder / "copy").generic_string();
    const std::string command = format("cp -rL '{}' '{}' && find '{}' -name '*.gz' -exec gunzip -f {} +",
                                       around.parent_path().generic_string(), copy, copy, "{}");
    if (std::system(command.c_str()) != 0) return {};
    std::string name = map.filename().string();
    if (endsWith(name, ".gz")) name.resize(name.size() - 3);
    return folder / "copy" / around.filename() / name;
}

Image cropped(const Image& whole, int left, int top, int width, int height) {
    Image piece{width, height, std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width * height))};
    for (int y = 0; y < height; ++y) {
        const auto from =
            whole.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(top + y) * whole.width + left);
        std::copy(from, from + 4 * width, piece.rgba.begin() + 4 * static_cast<std::ptrdiff_t>(y) * width);
    }
    return piece;
}

/// A tile of a tileset file that is a region of an image.
struct PartTile {
    std::size_t begin = 0;  // range of its element in the file's text
    std::size_t end = 0;
    int id = 0, left = 0, top = 0, width = 0, height = 0;  // px
    std::string picture;
};

std::optional<PartTile> nextPart(const std::string& text, std::size_t from) {
    for (std::size_t at = text.find("<tile id=", from); at != std::string::npos;
         at = text.find("<tile id=", at + 1)) {
        PartTile tile{.begin = at};
        int length = 0;
        if (std::sscanf(text.c_str() + at,
                        "<tile id=\"%d\" x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\"> <image %n", &tile.id,
                        &tile.left, &tile.top, &tile.width, &tile.height, &length) != 5 ||
            length == 0)
            continue;
        tile.end = text.find("/>", at + static_cast<std::size_t>(length)) + 2;
        constexpr std::string_view kSource = "source=\"";
        const std::size_t name = text.find(kSource, at) + kSource.size();
        tile.picture = text.substr(name, text.find('"', name) - name);
        return tile;
    }
    return std::nullopt;
}

/// Writes the tile's region to a separate image. @return the element that replaces the tile's element
std::string cutPicture(const PartTile& tile, const Path& folder) {
    const std::string picture = format("part-{}.png", tile.id);
    const Image whole = *decodeImage(*readFile(folder / tile.picture), "");
    const Image piece = cropped(whole, tile.left, tile.top, tile.width, tile.height);
    EXPECT_TRUE(writeFile(folder / picture, *encodePng(piece)).ok());
    return format("<tile id=\"{}\"><image width=\"{}\" height=\"{}\" source=\"{}\"/>", tile.id, piece.width,
                  piece.height, picture);
}

/// Replaces all tiles that are image regions, a feature of Tiled 1.9, by tiles with separate images, because
/// an older tmxrasterizer draws the whole image for each.
void cutPictures(const Path& folder) {
    for (const std::string& name : filesBelow(folder, ".tsx")) {
        const Path file = folder / name;
        std::string text = *readFile(file);
        for (auto tile = nextPart(text, 0); tile; tile = nextPart(text, tile->begin + 1))
            text.replace(tile->begin, tile->end - tile->begin, cutPicture(*tile, file.parent_path()));
        EXPECT_TRUE(writeFile(file, text).ok());
    }
}

class ImportPixelsTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        Result<std::unique_ptr<Window>> opened =
            Window::open({.title = "test", .width = 64, .height = 64, .hidden = true});
        ASSERT_TRUE(opened) << opened.error().text();
        window = std::move(*opened);
        Result<std::unique_ptr<GlDevice>> made = GlDevice::create();
        ASSERT_TRUE(made) << made.error().text();
        device = std::move(*made);
    }
    static void TearDownTestSuite() {
        device.reset();
        window.reset();
    }

    /// Returns the area of a map that tmxrasterizer draws: in infinite maps whole chunks of 16 x 16 cells. Of
    /// infinite isometric maps it begins farther left, since it leaves out the origin of their plane.
    static Rect areaOf(tiled::Map map) {
        for (tiled::Layer& layer : map.layers) {
            if (!map.infinite) break;
            const auto widen = [](int& first, int& count) {
                const int end = (first + count + 15) & ~15;
                first &= ~15;
                count = end - first;
            };
            widen(layer.x, layer.width);
            widen(layer.y, layer.height);
        }
        Rect area = boundsOf(map);
        if (map.infinite && map.orientation == tiled::Orientation::Isometric)
            area.x -= static_cast<float>(map.height * map.tileWidth) * 0.5f;
        return area;
    }

    /// Draws an area of the scene imported from a map on black.
    static Image drawn(const tiled::Map& map, const Rect& area, const Path& project,
                       const std::string& scene) {
        Json json = *parseJson(*readFile(project / scene), "");
        json.erase("background");  // tmxrasterizer does not draw it
        TypeRegistry types;
        registerSceneComponents(types);
        World world{types};
        AssetStore assets{project};
        assets.logging = false;
        world.provide(assets);
        const SceneContext context{types, nullptr, project};
        EXPECT_TRUE(loadScene(world, context, scene, writeJson(json)).ok());
        loadAssets(world, types, assets);

        const auto width = static_cast<int>(area.width);
        const auto height = static_cast<int>(area.height);
        const Vec2 size{area.width, area.height};
        SceneRenderer renderer{*device, assets, TextureFilter::Nearest};
        const TargetHandle target = device->createTarget(width, height);
        const Viewport viewport{.target = target, .width = width, .height = height};
        SceneView how;
        how.view = {Vec2{area.x, area.y} + size * 0.5f, size};
        // tmxrasterizer draws layers as if the view's center were at the parallax origin.
        how.parallaxOrigin = kPicture * 0.5f - map.parallaxOrigin;
        device->setViewport(viewport);
        device->clear({0, 0, 0, 255});
        DrawList list;
        list.begin(how.view);
        renderer.collect(world, how, list);
        renderer.renderer().draw(list, viewport);
        Image image = device->readPixels(target);
        device->destroyTarget(target);
        return image;
    }

    /// Adds a box of the map to the mask of pixels that are not compared.
    static void mask(std::vector<bool>& masked, const Rect& area, double left, double top, double right,
                     double bottom) {
        const auto width = static_cast<int>(area.width);
        const auto height = static_cast<int>(area.height);
        const auto areaX = static_cast<int>(area.x);
        const auto areaY = static_cast<int>(area.y);
        for (int y = std::max(static_cast<int>(top) - kAround - areaY, 0);
             y < std::min(static_cast<int>(bottom) + kAround - areaY, height); ++y) {
            for (int x = std::max(static_cast<int>(left) - kAround - areaX, 0);
                 x < std::min(static_cast<int>(right) + kAround - areaX, width); ++x) {
                masked[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)] = true;
            }
        }
    }

    /// Returns the mask of pixels that are not compared: tmxrasterizer draws outlines and names of shapes,
    /// and markers instead of objects made from templates.
    static std::vector<bool> maskOf(const tiled::Map& map, const Rect& area) {
        std::vector<bool> masked(static_cast<std::size_t>(area.width) *
                                 static_cast<std::size_t>(area.height));
        ImportReport ignored;
        const bool orthogonal = map.orientation == tiled::Orientation::Orthogonal;
        const tiled::Map flat = orthogonal ? map : orthogonalForm(map, ignored);
        for (const tiled::Layer& layer : flat.layers) {
            for (const tiled::Object& object : layer.objects) {
                const bool isTile = object.shape == tiled::Shape::Tile;
                if (isTile && object.templateFile.empty()) continue;
                const double reach = object.shape == tiled::Shape::Point ? 24.0 : 0.0;
                double left = object.x - reach;
                double top = object.y - (isTile ? object.height : reach * 1.5);
                double right = object.x + std::max(object.width, reach);
                double bottom = object.y + (isTile ? 32.0 : object.height) + reach;
                for (const Vec2 point : object.points) {
                    left = std::min(left, object.x + static_cast<double>(point.x));
                    top = std::min(top, object.y + static_cast<double>(point.y));
                    right = std::max(right, object.x + static_cast<double>(point.x));
                    bottom = std::max(bottom, object.y + static_cast<double>(point.y));
                }
                mask(masked, area, left, top, std::max(right, left + 32.0), bottom);
            }
        }
        return masked;
    }

    /// Returns the ratio of pixels outside the mask that are equal within the tolerance.
    static double alike(const Image& ours, const Image& theirs, const std::vector<bool>& masked) {
        std::size_t same = 0;
        std::size_t all = 0;
        for (std::size_t i = 0; i < masked.size(); ++i) {
            if (masked[i]) continue;
            ++all;
            const int alpha = theirs.rgba[i * 4 + 3];
            bool near = true;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const int shown = theirs.rgba[i * 4 + channel] * alpha / 255;
                near = near && std::abs(shown - ours.rgba[i * 4 + channel]) <= kTolerance;
            }
            same += near ? 1 : 0;
        }
        return all == 0 ? 1.0 : static_cast<double>(same) / static_cast<double>(all);
    }

    /// Imports a map, draws it and compares it with Tiled's picture. @return the ratio of equal pixels; no
    /// value if Tiled or the importer cannot read the map
    static std::optional<double> compare(const Path& file, const Path& folder, const std::string& name) {
        const Path project = folder / "game";
        EXPECT_TRUE(writeFile(project / "project.json", "{\"resolution\": [320, 180]}").ok());
        std::vector<Error> ignored;
        const Result<tiled::Map> map = loadTiledMap(file, ignored);
        if (!map) return {};
        const Result<ImportReport> report = importFile(file, {}, project);
        EXPECT_TRUE(report.ok());
        if (!report) return 0.0;
        const Rect area = areaOf(*map);
        const Image ours = drawn(*map, area, project, report->scene);
        cutPictures(file.parent_path().parent_path());
        const std::optional<Image> theirs = rasterized(file, folder);
        if (!theirs)
            return {};  // an example can use a newer format than the installed tmxrasterizer supports
        EXPECT_EQ(ours.width, theirs->width);
        EXPECT_EQ(ours.height, theirs->height);
        if (ours.width != theirs->width || ours.height != theirs->height) return 0.0;
        const double part = alike(ours, *theirs, maskOf(*map, area));
        std::printf("[   %6.2f%% ] %s\n", part * 100.0, name.c_str());
        if (const char* keep = std::getenv("PLUMB_KEEP_PICTURES"); keep != nullptr && part < kOwnEnough) {
            static_cast<void>(writeFile(Path{keep} / (name + "-ours.png"), *encodePng(ours)).ok());
            static_cast<void>(writeFile(Path{keep} / (name + "-tiled.png"), *encodePng(*theirs)).ok());
        }
        return part;
    }

    static std::unique_ptr<Window> window;
    static std::unique_ptr<GlDevice> device;
};
std::unique_ptr<Window> ImportPixelsTest::window;
std::unique_ptr<GlDevice> ImportPixelsTest::device;

TEST_F(ImportPixelsTest, mapsOfEveryOrientationLookAsTiledDrawsThem) {
    if (!canRasterize()) GTEST_SKIP() << "tmxrasterizer is not installed (Debian: tiled)";
    const std::vector<Path> maps = test::foreignMaps({".tmx", ".tmx.gz", "title.json"});
    ASSERT_FALSE(maps.empty());
    int compared = 0;
    for (const Path& original : maps) {
        SCOPED_TRACE(original.generic_string());
        const test::TemporaryFolder folder;
        const Path file = unpackedCopy(original, folder.path);
        const std::optional<double> part = compare(file, folder.path, original.stem().string());
        if (!part) continue;
        ++compared;
        EXPECT_GE(*part, kEnough);
    }
    EXPECT_GT(compared, 0);
}

/// A tileset image of 2 x 2 tiles, each of 32 x 36 px, in blocks of random colors with transparent corners.
Image blockPicture() {
    Image image{64, 72, std::vector<std::uint8_t>(64 * 72 * 4)};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            Random random = Random::seeded(static_cast<std::uint64_t>(y / 6 * 100 + x / 8));
            std::uint8_t* pixel = image.rgba.data() + 4 * (y * image.width + x);
            for (int channel = 0; channel < 3; ++channel)
                pixel[channel] = static_cast<std::uint8_t>(random.below(256));
            const bool isCorner = (x % 32 < 8 || x % 32 >= 24) && (y % 36 < 6 || y % 36 >= 30);
            pixel[3] = isCorner ? 0 : 255;
        }
    }
    return image;
}

std::string randomCells(int count, tiled::Gid flags, std::uint64_t seed) {
    Random random = Random::seeded(seed);
    std::string cells;
    for (int i = 0; i < count; ++i) {
        const tiled::Gid tile = random.below(5);  // 0: an empty cell
        const tiled::Gid bits = (static_cast<tiled::Gid>(random.below(16)) << 28) & flags;
        cells += format("{}{}", i == 0 ? "" : ",", tile == 0 ? 0 : tile | bits);
    }
    return cells;
}

TEST_F(ImportPixelsTest, everyAxisIndexAndFlipLooksAsTiledDrawsIt) {
    if (!canRasterize()) GTEST_SKIP() << "tmxrasterizer is not installed (Debian: tiled)";
    std::uint64_t seed = 0;
    for (const char* orientation : {"isometric", "staggered", "hexagonal", "turned"}) {
        for (const char* axis : {"x", "y"}) {
            for (const char* index : {"odd", "even"}) {
                for (const bool infinite : {false, true}) {
                    const std::string name =
                        format("{} {} {}{}", orientation, axis, index, infinite ? " infinite" : "");
                    SCOPED_TRACE(name);
                    const bool isTurned = std::string_view{orientation} == "turned";
                    const bool isHexagonal = isTurned || std::string_view{orientation} == "hexagonal";
                    const tiled::Gid flips = tiled::kFlipX | tiled::kFlipY;
                    const tiled::Gid flags = isTurned      ? tiled::kFlags
                                             : isHexagonal ? flips
                                                           : flips | tiled::kFlipDiagonal;
                    const std::string cells = randomCells(8 * 7, flags, ++seed);
                    const std::string data =
                        infinite ? "<chunk x=\"-3\" y=\"-5\" width=\"8\" height=\"7\">" + cells + "</chunk>"
                                 : cells;
                    const test::TemporaryFolder folder;
                    const Path file = folder.path / "copy/maps/map.tmx";
                    ASSERT_TRUE(
                        writeFile(file.parent_path() / "blocks.png", *encodePng(blockPicture())).ok());
                    ASSERT_TRUE(writeFile(file, format(R"(<?xml version="1.0" encoding="UTF-8"?>
<map version="1.8" orientation="{}" width="8" height="7" tilewidth="32" tileheight="24" infinite="{}"
 hexsidelength="12" staggeraxis="{}" staggerindex="{}">
 <tileset firstgid="1" name="blocks" tilewidth="32" tileheight="36" tilecount="4" columns="2">
  <tileoffset x="2" y="3"/><image source="blocks.png" width="64" height="72"/></tileset>
 <layer id="1" name="a" width="8" height="7"><data encoding="csv">{}</data></layer></map>)",
                                                       isHexagonal ? "hexagonal" : orientation,
                                                       infinite ? 1 : 0, axis, index, data))
                                    .ok());
                    const std::optional<double> part = compare(file, folder.path, name);
                    ASSERT_TRUE(part);
                    EXPECT_GE(*part, kOwnEnough);
                }
            }
        }
    }
}

}  // namespace
}  // namespace plumb

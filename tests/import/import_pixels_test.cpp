// Compares imported Tiled maps, drawn by the engine's renderer, with the images that Tiled's `tmxrasterizer`
// draws of the maps.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "import/import_file.hpp"
#include "import/loaders/tmx_loader.hpp"
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
constexpr int kTolerance = 12;    // maximum difference per channel, 0 to 255: filters round differently
constexpr double kEnough = 0.99;  // minimum ratio of equal pixels outside the mask
constexpr int kAround = 3;        // px: margin of areas not compared, since Tiled's outlines are wide

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

    /// Draws the scene imported from a map on black, in the size of the map.
    Image drawn(const tiled::Map& map, const Path& project, const std::string& scene) {
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

        const int width = map.width * map.tileWidth;
        const int height = map.height * map.tileHeight;
        const Vec2 size{static_cast<float>(width), static_cast<float>(height)};
        SceneRenderer renderer{*device, assets, TextureFilter::Nearest};
        const TargetHandle target = device->createTarget(width, height);
        const Viewport viewport{.target = target, .width = width, .height = height};
        SceneView how;
        how.view = {size * 0.5f, size};
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
    static void mask(std::vector<bool>& masked, const tiled::Map& map, double left, double top, double right,
                     double bottom) {
        const int width = map.width * map.tileWidth;
        const int height = map.height * map.tileHeight;
        for (int y = std::max(static_cast<int>(top) - kAround, 0);
             y < std::min(static_cast<int>(bottom) + kAround, height); ++y) {
            for (int x = std::max(static_cast<int>(left) - kAround, 0);
                 x < std::min(static_cast<int>(right) + kAround, width); ++x) {
                masked[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)] = true;
            }
        }
    }

    /// Returns the mask of pixels that are not compared: tmxrasterizer draws outlines and names of shapes,
    /// and markers instead of objects made from templates.
    static std::vector<bool> maskOf(const tiled::Map& map) {
        std::vector<bool> masked(static_cast<std::size_t>(map.width * map.tileWidth) *
                                 static_cast<std::size_t>(map.height * map.tileHeight));
        for (const tiled::Layer& layer : map.layers) {
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
                mask(masked, map, left, top, std::max(right, left + 32.0), bottom);
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

    static std::unique_ptr<Window> window;
    static std::unique_ptr<GlDevice> device;
};
std::unique_ptr<Window> ImportPixelsTest::window;
std::unique_ptr<GlDevice> ImportPixelsTest::device;

TEST_F(ImportPixelsTest, orthogonalMapsLookAsTiledDrawsThem) {
    if (!canRasterize()) GTEST_SKIP() << "tmxrasterizer is not installed (Debian: tiled)";
    const std::vector<Path> maps = test::foreignMaps({".tmx", ".tmx.gz", "title.json"});
    ASSERT_FALSE(maps.empty());
    int compared = 0;
    for (const Path& original : maps) {
        SCOPED_TRACE(original.generic_string());
        const test::TemporaryFolder folder;
        const Path file = unpackedCopy(original, folder.path);
        const Path project = folder.path / "game";
        ASSERT_TRUE(writeFile(project / "project.json", "{\"resolution\": [320, 180]}").ok());
        std::vector<Error> ignored;
        const Result<tiled::Map> map = loadTiledMap(file, ignored);
        // Of infinite maps tmxrasterizer draws only the painted area.
        if (!map || map->orientation != tiled::Orientation::Orthogonal || map->infinite) continue;
        const Result<ImportReport> report = importFile(file, {}, project);
        ASSERT_TRUE(report.ok()) << report.error().text();
        const Image ours = drawn(*map, project, report->scene);
        cutPictures(folder.path / "copy");
        const std::optional<Image> theirs = rasterized(file, folder.path);
        if (!theirs) continue;  // an example can use a newer format than the installed tmxrasterizer supports
        ASSERT_EQ(ours.width, theirs->width);
        ASSERT_EQ(ours.height, theirs->height);
        const double part = alike(ours, *theirs, maskOf(*map));
        ++compared;
        std::printf("[   %6.2f%% ] %s\n", part * 100.0, original.filename().string().c_str());
        EXPECT_GE(part, kEnough);
        if (const char* keep = std::getenv("PLUMB_KEEP_PICTURES"); keep != nullptr && part < kEnough) {
            const std::string stem = original.stem().string();
            static_cast<void>(writeFile(Path{keep} / (stem + "-ours.png"), *encodePng(ours)).ok());
            static_cast<void>(writeFile(Path{keep} / (stem + "-tiled.png"), *encodePng(*theirs)).ok());
        }
    }
    EXPECT_GT(compared, 0);
}

}  // namespace
}  // namespace plumb

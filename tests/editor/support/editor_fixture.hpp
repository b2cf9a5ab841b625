#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "app/engine_types.hpp"
#include "assets/asset_store.hpp"
#include "core/file.hpp"
#include "editor/model/commands/insert_entities.hpp"
#include "editor/model/workspace.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/drawing/label.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/name.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/prefab.hpp"

namespace plumb::editor {

inline constexpr std::string_view kScene = "scenes/level.scene.json";

/// The scene that most tests open: a player with a lamp as child, a camera that follows the player, a crate,
/// a sign, a tile layer, and one component of an unknown type.
inline constexpr std::string_view kSceneText = R"({
  "format": 1,
  "effects": {},
  "layers": [],
  "entities": [
    {
      "id": "0000000000000001",
      "name": "camera",
      "components": {
        "Transform": {
          "position": [160, 90]
        },
        "Camera": {
          "follow": "0000000000000002"
        }
      }
    },
    {
      "id": "0000000000000002",
      "name": "player",
      "components": {
        "Transform": {
          "position": [40, 100]
        },
        "RigidBody": {},
        "BoxCollider": {
          "width": 16,
          "height": 24
        },
        "FromTheFuture": {
          "strength": 3
        }
      }
    },
    {
      "id": "0000000000000003",
      "name": "lamp",
      "parent": "0000000000000002",
      "components": {
        "Transform": {
          "position": [10, -10]
        }
      }
    },
    {
      "id": "0000000000000004",
      "name": "crate",
      "components": {
        "Transform": {
          "position": [200, 64]
        },
        "BoxCollider": {
          "width": 31,
          "height": 31
        }
      }
    },
    {
      "id": "0000000000000005",
      "name": "sign",
      "components": {
        "Transform": {
          "position": [100, 20]
        },
        "Label": {
          "text": "Hello"
        }
      }
    },
    {
      "id": "0000000000000006",
      "name": "ground",
      "components": {
        "Transform": {
          "position": [0, 0]
        },
        "TileLayer": {
          "cells": {
            "width": 4,
            "height": 3,
            "rows": ["0 0 0 0", "0 1 1 0", "2 2 2 2"]
          },
          "tileSize": [16, 16]
        }
      }
    }
  ]
}
)";

/// An editor without a window, on a project of its own in a temporary folder.
class EditorFixture : public testing::Test {
protected:
    EditorFixture()
        : types_{engineTypes()},
          assets_{root_},
          prefabs_{types_, root_},
          workspace{types_, assets_, {root_}, &prefabs_} {
        EXPECT_TRUE(writeFile(root_ / kScene, kSceneText).ok());
        EXPECT_TRUE(workspace.open(kScene).ok());
    }

    [[nodiscard]] ObjectId named(std::string_view name) const {
        for (const ObjectId id : workspace.document.objects()) {
            if (workspace.document.nameOf(id) == name) return id;
        }
        return {};
    }
    [[nodiscard]] Vec2 positionOf(ObjectId id) const {
        return workspace.document.world.get<Transform>(workspace.document.find(id)).position;
    }
    [[nodiscard]] std::string fileText() const { return fileText(kScene); }
    [[nodiscard]] std::string fileText(std::string_view path) const { return *readFile(root_ / path); }
    void putFile(std::string_view path, std::string_view text) {
        EXPECT_TRUE(writeFile(root_ / path, text).ok());
    }

private:
    static Path makeFolder() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        Path folder = std::filesystem::temp_directory_path() /
                      (std::string{"plumb_editor_"} + test->test_suite_name() + "_" + test->name());
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder / "scenes");
        return folder;
    }
    /// Declared first, so that the folder is deleted last: closing an editor still writes files into it.
    struct Folder {
        Path path;
        ~Folder() { std::filesystem::remove_all(path); }
    };
    Folder folder_{makeFolder()};
    Path root_ = folder_.path;
    TypeRegistry types_;
    AssetStore assets_;
    PrefabLibrary prefabs_;

protected:
    Workspace workspace;
};

}  // namespace plumb::editor

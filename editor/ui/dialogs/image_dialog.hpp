#pragma once

#include <string>

#include "editor/model/assets/asset_browser.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The dialog that shows an image of the project in full; its buttons make other assets of it.
class ImageDialog {
public:
    void open(std::string path) { wanted_ = std::move(path); }
    /// @param browser  receives the selection of a file made from the image
    void draw(Ui& ui, AssetBrowser& browser);

private:
    std::string wanted_;  ///< image whose dialog is requested
    std::string path_;
};

/// Creates the tileset made of an image and selects its file.
void makeTilesetOf(Ui& ui, AssetBrowser& browser, const std::string& image);

}  // namespace plumb::editor::ui

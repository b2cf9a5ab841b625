#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace plumb {

// A game on the web talks with the page around it (player/targets/web/page.js). On the desktop there is no
// page: these functions do nothing.

[[nodiscard]] bool hasPage();

/// Sets the function that makes the link of the run so far, which the page offers.
/// @param makeLink  called between frames, or after the program has failed: then `afterFailure` is true and
///                  the state of the game must not be read. Empty: there is no link any more
void offerLink(std::function<std::string(bool afterFailure)> makeLink);

/// Tells the page something; the topics are those of onGame in page.js. @param text  UTF-8
void tellPage(std::string_view topic, std::string_view text);

}  // namespace plumb

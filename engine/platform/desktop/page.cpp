#include "platform/page.hpp"

namespace plumb {

bool hasPage() { return false; }
void offerLink(std::function<std::string(bool afterFailure)>) {}
void tellPage(std::string_view, std::string_view) {}

}  // namespace plumb

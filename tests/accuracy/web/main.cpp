// What the page of the accuracy lab calls (worker.js): functions of Lab for JavaScript. Texts that they
// return are valid until the next call.

#include <emscripten/emscripten.h>

#include "tests/accuracy/web/lab.hpp"

namespace {

using namespace plumb::accuracy;

Lab lab;
std::string answer;

const char* give(std::string text) {
    answer = std::move(text);
    return answer.c_str();
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* labScenes() { return give(Lab::scenesJson()); }

EMSCRIPTEN_KEEPALIVE const char* labMeasure(const char* scene, int substeps, int integrator, int trees,
                                            double seconds) {
    return give(lab.measure(scene, methodOf(substeps, integrator, trees != 0), seconds));
}

EMSCRIPTEN_KEEPALIVE const char* labRecord(const char* scene, int substeps, int integrator, int trees) {
    return give(lab.record(scene, methodOf(substeps, integrator, trees != 0)));
}

EMSCRIPTEN_KEEPALIVE const float* labPoses() { return lab.poses().data(); }

EMSCRIPTEN_KEEPALIVE int labPoseCount() { return static_cast<int>(lab.poses().size()); }

EMSCRIPTEN_KEEPALIVE const char* labChart(const char* scene) { return give(lab.chart(scene)); }
}

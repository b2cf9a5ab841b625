#include <plumb.hpp>

using namespace plumb;

void addScore(Module& module);
void addWaves(Module& module);
void addHealth(Module& module);
void addTopDown(Module& module);
void addGuns(Module& module);
void addWalking(Module& module);
void addLevelKeys(Module& module);
void addShuttles(Module& module);
void addSparks(Module& module);

PLUMB_MODULE(module) {
    addScore(module);
    addWaves(module);
    addHealth(module);
    addTopDown(module);
    addGuns(module);
    addWalking(module);
    addLevelKeys(module);
    addShuttles(module);
    addSparks(module);
}

#include "studies/engine/scene_entry.hpp"

#include <algorithm>

#include "core/named.hpp"

namespace ordo::studies {
namespace {

std::vector<SceneEntry>& catalogue() {
    static std::vector<SceneEntry> scenes;
    return scenes;
}

}  // namespace

bool enrol(SceneEntry entry) {
    auto& scenes = catalogue();
    const auto after = [&](const SceneEntry& other) { return entry.name < other.name; };
    scenes.insert(std::find_if(scenes.begin(), scenes.end(), after), std::move(entry));
    return true;
}

const std::vector<SceneEntry>& all_scenes() { return catalogue(); }

const SceneEntry& scene_named(const std::string& name, const std::string& where) {
    return named(all_scenes(), name, where, "there is no scene");
}

}  // namespace ordo::studies

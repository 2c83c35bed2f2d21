#pragma once

#include <map>
#include <string>

namespace cydonia {

// What every key of a scene file means, as docs/scene-file.md says it.
class Manual {
  public:
    explicit Manual(const std::string& markdown);
    static Manual load();  // the one that ships

    // Of a key of a table, "render.camera" and "name"; of a stage's, "terrain.stage
    // distance". One line; empty: it says nothing.
    std::string meaning(const std::string& table, const std::string& key) const;

  private:
    std::map<std::string, std::string> meanings_;  // by "table.key"
};

// The text of a scene file with a comment for every key that has none.
std::string commented(const std::string& scene, const Manual& manual);

}  // namespace cydonia

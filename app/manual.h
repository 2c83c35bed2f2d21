#pragma once

#include <map>
#include <string>

namespace cydonia {

// The meaning of every key of a scene file, read from docs/scene-file.md.
class Manual {
  public:
    explicit Manual(const std::string& markdown);
    static Manual load();  // the one that ships

    // What a key of a table means, in one line; empty if the manual does not say. Tables
    // are called "render.camera", those of stages "terrain.stage distance".
    std::string meaning(const std::string& table, const std::string& key) const;

  private:
    std::map<std::string, std::string> meanings_;  // by "table.key"
};

// The text of a scene file, with a comment added to every key that has none.
std::string commented(const std::string& scene, const Manual& manual);

}  // namespace cydonia

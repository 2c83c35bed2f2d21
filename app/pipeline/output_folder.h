#pragma once

#include <filesystem>
#include <string>

namespace cydonia {

// A scene's output folder, which is made and locked for this process. Throws failure() if
// it is a file, cannot be written to, is full, or another run is at work in it.
class OutputFolder {
  public:
    // Processes that share the folder write different files.
    enum class Claim { kAlone, kShared };
    explicit OutputFolder(const std::filesystem::path& path, Claim claim = Claim::kAlone);
    ~OutputFolder();
    // Marks the folder as this scene's. Throws bad_request() if it is another scene's,
    // because the files of both would be mixed.
    void belongs_to(const std::string& scene) const;
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

  private:
    std::filesystem::path path_;
    int lock_ = -1;  // file descriptor
};

}  // namespace cydonia

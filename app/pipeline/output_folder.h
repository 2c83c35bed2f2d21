#pragma once

#include <filesystem>
#include <string>

namespace cydonia {

// A scene's output folder, made and claimed for this process: throws failure() when it is
// a file, cannot be written, is full, or another run is at work in it.
class OutputFolder {
  public:
    // Processes that share it write files of different names.
    enum class Claim { kAlone, kShared };
    explicit OutputFolder(const std::filesystem::path& path, Claim claim = Claim::kAlone);
    ~OutputFolder();
    // From now on it is this scene's. Throws bad_request() when it is another's, whose
    // files would stand among those of this one.
    void belongs_to(const std::string& scene) const;
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

  private:
    std::filesystem::path path_;
    int lock_ = -1;  // file descriptor
};

}  // namespace cydonia

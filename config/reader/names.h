#pragma once

#include <string>
#include <vector>

#include "config/reader/units.h"

namespace cydonia::config {

// The names that the groups of a distance stage may refer to, as far as the stage was
// read.
struct Names {
    std::vector<std::string> groups;
    std::vector<std::string> profiles;  // of the stage; others ship with the program
    bool random_weights = true;         // without them profiles do not apply
};

// The unit of the name of a group before this one. Its message is "no group 'rimm' before
// this one; did you mean 'rim'?"
struct GroupName {
    const std::vector<std::string>& known;
    std::string_view where;       // " before this one"
    std::string_view other = {};  // a word that stands for no group but is allowed
    static constexpr bool kVaries = false;
    std::string read(const Value& value, Files& files) const;
    std::string text(const std::string& name) const { return name; }
    std::string schema() const { return Word{}.schema(); }
};

// The unit of the name of a profile of the stage or of one that ships with the program.
struct ProfileName {
    const std::vector<std::string>& own;
    static constexpr bool kVaries = false;
    std::string read(const Value& value, Files& files) const;
    std::string text(const std::string& name) const { return name; }
    std::string schema() const { return Word{}.schema(); }
};

// The path of config/profiles/NAME.csv. Throws failure() when it is missing.
std::filesystem::path shipped_profile(const std::string& name);

}  // namespace cydonia::config

#pragma once

#include <string>
#include <vector>

#include "config/reader/units.h"

namespace cydonia::config {

// What the groups of a distance stage may refer to, as far as it was read.
struct Names {
    std::vector<std::string> groups;
    std::vector<std::string> profiles;  // of the stage; others ship with the program
    bool random_weights = true;         // without them profiles do not apply
};

// A group so far: "no group 'rimm' before this one; did you mean 'rim'?"
struct GroupName {
    const std::vector<std::string>& known;
    std::string_view where;       // " before this one"
    std::string_view other = {};  // a word that stands for no group but is allowed
    static constexpr bool kVaries = false;
    std::string read(const Value& value, Files& files) const;
    std::string text(const std::string& name) const { return name; }
    std::string schema() const { return Word{}.schema(); }
};

// A profile of the stage or one that ships.
struct ProfileName {
    const std::vector<std::string>& own;
    static constexpr bool kVaries = false;
    std::string read(const Value& value, Files& files) const;
    std::string text(const std::string& name) const { return name; }
    std::string schema() const { return Word{}.schema(); }
};

// config/profiles/NAME.csv. Throws failure().
std::filesystem::path shipped_profile(const std::string& name);

}  // namespace cydonia::config

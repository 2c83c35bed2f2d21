#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cydonia::bench {

// What is hidden of a pair until it is scored.
struct Pair {
    bool real_is_a = false;
    std::string landform;  // its exemplar
};

// As text that tells nothing to whoever opens it, and back. Throws bad_request.
std::string hidden(const std::vector<Pair>& pairs, std::uint64_t salt);
std::vector<Pair> revealed(const std::string& text);

// Answers are lines "01 A": in the first pair A is the real one. Lines that say neither A
// nor B count as not answered. One letter a pair, '?' where none was given; throws
// bad_request.
std::string answers_of(const std::string& text, std::size_t pairs);

// How likely it is to be right at least `right` times of `all` by guessing.
double chance_of_at_least(int right, int all);

}  // namespace cydonia::bench

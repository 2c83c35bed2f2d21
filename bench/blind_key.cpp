#include "bench/blind_key.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "field/error.h"
#include "field/random.h"

namespace cydonia::bench {

namespace {

// The byte that hides the i-th.
unsigned mask(std::uint64_t salt, std::size_t i) {
    return static_cast<unsigned>(hash_of({salt, key("key"), i}) & 0xff);
}

}  // namespace

std::string hidden(const std::vector<Pair>& pairs, std::uint64_t salt) {
    std::string plain;
    for (const Pair& pair : pairs)
        plain += fmt::format("{} {}\n", pair.real_is_a ? 'A' : 'B', pair.landform);
    std::string text = fmt::format("{:016x}", salt);
    for (std::size_t i = 0; i < plain.size(); ++i)
        text +=
            fmt::format("{:02x}", static_cast<unsigned char>(plain[i]) ^ mask(salt, i));
    return text + "\n";
}

std::vector<Pair> revealed(const std::string& text) try {
    const std::uint64_t salt = std::stoull(text.substr(0, 16), nullptr, 16);
    std::string plain;
    for (std::size_t i = 16; i + 1 < text.size(); i += 2)
        plain += static_cast<char>(std::stoul(text.substr(i, 2), nullptr, 16) ^
                                   mask(salt, plain.size()));
    std::vector<Pair> pairs;
    std::istringstream lines(plain);
    for (std::string line; std::getline(lines, line);) {
        if (line.size() < 3 || (line[0] != 'A' && line[0] != 'B')) throw 0;
        pairs.push_back({line[0] == 'A', line.substr(2)});
    }
    return pairs;
} catch (...) {
    throw bad_request("the key is damaged: make the pairs again");
}

std::string answers_of(const std::string& text, std::size_t pairs) {
    std::string answers(pairs, '?');
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::size_t number = 0;
        std::string answer;
        if (line.starts_with('#') || !(words >> number >> answer)) continue;
        if (number < 1 || number > pairs)
            throw bad_request("answers.txt: there is no pair {}", number);
        if (answer == "a" || answer == "A") answers[number - 1] = 'A';
        if (answer == "b" || answer == "B") answers[number - 1] = 'B';
    }
    return answers;
}

double chance_of_at_least(int right, int all) {
    double sum = 0.0;
    for (int k = right; k <= all; ++k)
        sum += std::exp(std::lgamma(all + 1.0) - std::lgamma(k + 1.0) -
                        std::lgamma(all - k + 1.0) - all * std::log(2.0));
    return std::min(sum, 1.0);
}

}  // namespace cydonia::bench

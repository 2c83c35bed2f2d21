#pragma once

#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>

namespace cydonia::test {

// What a value breaks of a JSON Schema; empty: nothing. Of draft 7 what our schemas use;
// throws for a word that it does not know, so that none goes unchecked.
class Validator {
    using Json = nlohmann::json;

  public:
    explicit Validator(const Json& schema) : root_(schema) {}

    std::string complaint(const Json& value) const { return complaint(root_, value, ""); }

  private:
    static bool is(const std::string& type, const Json& v) {
        if (type == "object") return v.is_object();
        if (type == "array") return v.is_array();
        if (type == "string") return v.is_string();
        if (type == "boolean") return v.is_boolean();
        if (type == "integer") return v.is_number_integer();
        if (type == "number") return v.is_number();
        throw std::runtime_error("unknown type " + type);
    }

    std::string complaint(const Json& schema, const Json& v,
                          const std::string& at) const {
        for (const auto& [word, rule] : schema.items())
            if (std::string wrong = broken(schema, word, rule, v, at); !wrong.empty())
                return wrong;
        return "";
    }

    std::string broken(const Json& schema, const std::string& word, const Json& rule,
                       const Json& v, const std::string& at) const {
        const auto no = [&](bool holds) {
            return holds ? ""
                         : at + ": " + v.dump().substr(0, 60) + " breaks " + word + " " +
                               rule.dump().substr(0, 60);
        };
        if (word == "$schema" || word == "title" || word == "description") return "";
        if (word == "definitions" || word == "required" || word == "additionalProperties")
            return word == "required" && v.is_object() ? missing(rule, v, at) : "";
        if (word == "$ref") return complaint(referred(rule), v, at);
        if (word == "type") return no(is(rule, v));
        if (word == "enum")
            return no(std::find(rule.begin(), rule.end(), v) != rule.end());
        if (word == "const") return no(rule == v);
        if (word == "anyOf") return any(rule, v, at);
        if (word == "properties") return v.is_object() ? members(schema, v, at) : "";
        if (word == "items") return v.is_array() ? elements(rule, v, at) : "";
        if (word == "minItems") return no(!v.is_array() || v.size() >= rule);
        if (word == "maxItems") return no(!v.is_array() || v.size() <= rule);
        if (word == "minimum") return no(!v.is_number() || v >= rule);
        if (word == "maximum") return no(!v.is_number() || v <= rule);
        if (word == "exclusiveMinimum") return no(!v.is_number() || v > rule);
        if (word == "exclusiveMaximum") return no(!v.is_number() || v < rule);
        if (word == "maxLength")
            return no(!v.is_string() || v.get<std::string>().size() <= rule);
        if (word == "pattern")
            return no(!v.is_string() ||
                      std::regex_search(v.get<std::string>(),
                                        std::regex(rule.get<std::string>())));
        throw std::runtime_error("unknown word " + word);
    }

    const Json& referred(const std::string& pointer) const {
        return root_.at(Json::json_pointer(pointer.substr(1)));  // "#/definitions/a"
    }

    static std::string missing(const Json& names, const Json& v, const std::string& at) {
        for (const std::string name : names)
            if (!v.contains(name)) return at + ": misses " + name;
        return "";
    }

    std::string any(const Json& schemas, const Json& v, const std::string& at) const {
        std::string all;
        for (const Json& schema : schemas) {
            const std::string wrong = complaint(schema, v, at);
            if (wrong.empty()) return "";
            all += "\n  " + wrong;
        }
        return at + ": none of" + all;
    }

    std::string members(const Json& schema, const Json& v, const std::string& at) const {
        for (const auto& [name, member] : v.items()) {
            const std::string path = at + "." + name;
            const Json& known = schema.at("properties");
            const Json rest = schema.value("additionalProperties", Json(true));
            std::string wrong;
            if (known.contains(name))
                wrong = complaint(known.at(name), member, path);
            else if (rest.is_object())
                wrong = complaint(rest, member, path);
            else if (rest == false)
                wrong = path + ": unknown";
            if (!wrong.empty()) return wrong;
        }
        return "";
    }

    std::string elements(const Json& rule, const Json& v, const std::string& at) const {
        for (std::size_t i = 0; i < v.size(); ++i) {
            if (rule.is_array() && i >= rule.size()) break;
            const Json& schema = rule.is_array() ? rule.at(i) : rule;
            const std::string wrong =
                complaint(schema, v[i], at + "[" + std::to_string(i) + "]");
            if (!wrong.empty()) return wrong;
        }
        return "";
    }

    Json root_;
};

}  // namespace cydonia::test

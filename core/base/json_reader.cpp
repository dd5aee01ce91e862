#include "core/base/json_reader.h"

#include "core/base/text_check.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace knittsim {

namespace {

using nlohmann::json;

const json kEmptyObject = json::object();

std::string shortest(double number) {
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    return {buffer.data(), result.ptr};
}

std::string describe(const json& value) {
    if (value.is_number()) {
        return value.is_number_float() ? shortest(value.get<double>()) : value.dump();
    }
    if (value.is_string()) {
        constexpr std::size_t kMaxShown = 40;
        const auto& text = value.get_ref<const std::string&>();
        return text.size() <= kMaxShown ? '"' + text + '"'
                                        : "a text of " + std::to_string(text.size()) + " bytes";
    }
    return value.is_null()      ? "null"
           : value.is_boolean() ? (value.get<bool>() ? "true" : "false")
                                : value.type_name();
}

std::string rangeText(const std::string& kind, const std::string& min, const std::string& max) {
    return kind + " from " + min + " to " + max;
}

std::string join(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

/// The library's message without its own number and position ("[json...] parse error at line 1, column 2:
/// ..."), in ASCII: it may quote broken UTF-8.
std::string plainMessage(std::string message) {
    const std::size_t column = message.find("column ");
    const std::string_view end = column == std::string::npos ? "] " : ": ";
    const std::size_t found = message.find(end, column == std::string::npos ? 0 : column);
    if (found != std::string::npos) {
        message.erase(0, found + end.size());
    }
    std::ranges::replace_if(
        message, [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '?');
    return message;
}

Place placeOfByte(std::string_view text, std::size_t byte, const std::string& file) {
    const std::string_view before = text.substr(0, std::min(text.size(), byte > 0 ? byte - 1 : 0));
    const std::size_t lineStart = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return Place{.file = file,
                 .line = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
                 .column = 1 + static_cast<int>(before.size() - lineStart)};
}

} // namespace

Result<json> parseJson(std::string_view text, const std::string& file) {
    if (auto reason = whyNotText(text, file)) {
        return std::move(*reason);
    }
    try {
        return json::parse(text.begin(), text.end());
    } catch (const json::parse_error& error) {
        return Diagnostic{
            "KS0003", Severity::Error, placeOfByte(text, error.byte, file), {plainMessage(error.what())}};
    } catch (const json::exception& error) {
        return Diagnostic{"KS0003", Severity::Error, Place{.file = file}, {plainMessage(error.what())}};
    }
}

JsonReader::JsonReader(const json& value, std::string file, Diagnostics& diagnostics, std::string path)
    : m_object(&value), m_file(std::move(file)), m_path(std::move(path)), m_diagnostics(&diagnostics) {
    if (!value.is_object()) {
        m_object = &kEmptyObject;
        add({"KS0004",
             Severity::Error,
             Place{.file = m_file},
             {m_path.empty() ? "the file" : m_path, describe(value), "an object"}});
    }
}

std::string JsonReader::pathOf(const std::string& key) const {
    return m_path.empty() ? key : m_path + '.' + key;
}

void JsonReader::report(const std::string& key, std::string found, std::string expected) {
    add({"KS0004",
         Severity::Error,
         Place{.file = m_file},
         {pathOf(key), std::move(found), std::move(expected)}});
}

void JsonReader::add(Diagnostic problem) {
    if (m_diagnostics->size() < kMaxProblems) {
        m_diagnostics->push_back(std::move(problem));
    } else if (m_diagnostics->size() == kMaxProblems) {
        m_diagnostics->push_back(
            {"KS0115", Severity::Error, Place{.file = m_file}, {std::to_string(kMaxProblems)}});
    }
}

bool JsonReader::has(const std::string& key) const {
    return m_object->contains(key);
}

const json* JsonReader::find(const std::string& key, const std::string& expected) {
    m_known.push_back(key);
    if (m_object == &kEmptyObject) {
        return nullptr;
    }
    const auto found = m_object->find(key);
    if (found == m_object->end()) {
        add({"KS0005", Severity::Error, Place{.file = m_file}, {pathOf(key), expected}});
        return nullptr;
    }
    return &*found;
}

std::string JsonReader::text(const std::string& key) {
    const json* value = find(key, "a text");
    if (value && value->is_string() && !value->get_ref<const std::string&>().empty()) {
        return value->get<std::string>();
    }
    if (value) {
        report(key, describe(*value), "a text");
    }
    return {};
}

std::string JsonReader::optionalText(const std::string& key) {
    if (!has(key)) {
        m_known.push_back(key);
        return {};
    }
    const json* value = find(key, "a text");
    if (!value->is_string()) {
        report(key, describe(*value), "a text");
        return {};
    }
    return value->get<std::string>();
}

std::string JsonReader::choice(const std::string& key, const std::vector<std::string>& allowed) {
    const std::string expected = "one of " + join(allowed);
    const json* value = find(key, expected);
    if (value && value->is_string() &&
        std::ranges::count(allowed, value->get_ref<const std::string&>()) > 0) {
        return value->get<std::string>();
    }
    if (value) {
        report(key, describe(*value), expected);
    }
    return allowed.front();
}

double JsonReader::number(const std::string& key, double min, double max) {
    const std::string expected = rangeText("a number", shortest(min), shortest(max));
    const json* value = find(key, expected);
    if (value && value->is_number() && value->get<double>() >= min && value->get<double>() <= max) {
        return value->get<double>();
    }
    if (value) {
        report(key, describe(*value), expected);
    }
    return min;
}

int JsonReader::integer(const std::string& key, int min, int max) {
    const std::string expected = rangeText("a whole number", std::to_string(min), std::to_string(max));
    const json* value = find(key, expected);
    if (value && value->is_number_integer() && value->get<double>() >= min && value->get<double>() <= max) {
        return value->get<int>();
    }
    if (value) {
        report(key, describe(*value), expected);
    }
    return min;
}

bool JsonReader::flag(const std::string& key) {
    const json* value = find(key, "true or false");
    if (value && !value->is_boolean()) {
        report(key, describe(*value), "true or false");
    }
    return value && value->is_boolean() && value->get<bool>();
}

JsonReader JsonReader::object(const std::string& key) {
    const json* value = find(key, "an object");
    return {value ? *value : kEmptyObject, m_file, *m_diagnostics, pathOf(key)};
}

std::vector<json> JsonReader::array(const std::string& key, std::size_t min, std::size_t max) {
    const std::string expected =
        "an array of " + std::to_string(min) + " to " + std::to_string(max) + " values";
    const json* value = find(key, expected);
    if (value && value->is_array() && value->size() >= min && value->size() <= max) {
        return value->get<std::vector<json>>();
    }
    if (value) {
        report(key, value->is_array() ? "an array of " + std::to_string(value->size()) : describe(*value),
               expected);
    }
    return {};
}

std::vector<std::string> JsonReader::keys() const {
    std::vector<std::string> names;
    for (const auto& item : m_object->items()) {
        names.push_back(item.key());
    }
    return names;
}

void JsonReader::rejectUnknownKeys() {
    for (const std::string& key : keys()) {
        if (std::ranges::count(m_known, key) == 0) {
            report(key, "not known", "one of " + join(m_known));
        }
    }
}

double roundDecimal(double value) {
    std::array<char, 32> buffer{};
    char* const end = buffer.data() + buffer.size();
    const auto written = std::to_chars(buffer.data(), end, value, std::chars_format::general, 12);
    double rounded = value;
    std::from_chars(buffer.data(), written.ptr, rounded);
    return rounded;
}

} // namespace knittsim

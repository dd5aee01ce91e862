#include "core/base/json_places.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <string>
#include <unordered_map>

namespace knittsim {

namespace {

using nlohmann::json;

constexpr std::size_t kDeepest = 16; ///< levels; no reader goes so far

/// Walks through a text and tells others how far it has come.
class Cursor {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Cursor(const char* at, const char*& told) : m_at(at), m_told(&told) {}

    reference operator*() const { return *m_at; }
    Cursor& operator++() {
        *m_told = ++m_at;
        return *this;
    }
    Cursor operator++(int) {
        const Cursor before = *this;
        ++*this;
        return before;
    }
    bool operator==(const Cursor& other) const { return m_at == other.m_at; }

private:
    const char* m_at;
    const char** m_told;
};

/// Notes where each key and each value of an array ends, or begins where it is no single word.
class PlaceFinder : public nlohmann::json_sax<json> {
public:
    PlaceFinder(const char* begin, const char* const& now) : m_begin(begin), m_now(now) {}

    /// Bytes before the last one of what is at a path ("rows.2.name" or "rows[2].name"), or of the innermost
    /// thing around it.
    std::size_t find(std::string path) const {
        std::ranges::replace(path, '[', '.');
        std::erase(path, ']');
        while (!path.empty() && !m_places.contains(path)) {
            const std::size_t dot = path.rfind('.');
            path.resize(dot == std::string::npos ? 0 : dot);
        }
        const auto found = m_places.find(path);
        return found == m_places.end() ? 0 : found->second;
    }

    bool null() override { return value(); }
    bool boolean(bool) override { return value(); }
    bool number_integer(number_integer_t) override { return value(); }
    bool number_unsigned(number_unsigned_t) override { return value(); }
    bool number_float(number_float_t, const string_t&) override { return value(); }
    bool string(string_t&) override { return value(); }
    bool binary(binary_t&) override { return value(); }
    bool start_object(std::size_t) override { return begin(false); }
    bool start_array(std::size_t) override { return begin(true); }
    bool end_object() override { return end(); }
    bool end_array() override { return end(); }
    bool parse_error(std::size_t, const std::string&, const json::exception&) override { return false; }

    bool key(string_t& name) override {
        note(name);
        return true;
    }

private:
    struct Level {
        std::size_t path = 0; ///< length of the path
        bool isArray = false;
        int count = 0;
    };

    bool value() {
        if (m_levels.empty()) {
            m_places[m_path] = offset();
        } else if (m_levels.back().isArray) {
            note(std::to_string(m_levels.back().count++));
        }
        return true;
    }

    bool begin(bool isArray) {
        value();
        m_levels.push_back({m_path.size(), isArray, 0});
        return true;
    }

    bool end() {
        m_levels.pop_back();
        return true;
    }

    void note(const std::string& name) {
        if (m_levels.size() > kDeepest) {
            return;
        }
        m_path.resize(m_levels.back().path);
        m_path += (m_path.empty() ? "" : ".") + name;
        m_places[m_path] = offset();
    }

    std::size_t offset() const { return static_cast<std::size_t>(m_now - m_begin) - 1; }

    const char* m_begin;
    const char* const& m_now;
    std::string m_path;
    std::vector<Level> m_levels;
    std::unordered_map<std::string, std::size_t> m_places;
};

} // namespace

void tellLines(std::string_view text, Diagnostics& problems) {
    const auto names = [](const Diagnostic& d) {
        return (d.id == "KS0004" || d.id == "KS0005") && d.place.line < 0 && !d.arguments.empty();
    };
    if (std::ranges::none_of(problems, names)) {
        return;
    }
    const char* now = text.data();
    PlaceFinder finder(text.data(), now);
    json::sax_parse(Cursor(text.data(), now), Cursor(text.data() + text.size(), now), &finder);
    for (Diagnostic& problem : problems) {
        if (names(problem)) {
            const std::string_view before = text.substr(0, finder.find(problem.arguments.front()));
            problem.place.line = 1 + static_cast<int>(std::ranges::count(before, '\n'));
        }
    }
}

} // namespace knittsim

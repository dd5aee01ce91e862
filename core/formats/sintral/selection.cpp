#include "core/formats/sintral/selection.h"

#include "core/formats/sintral/words.h"

#include <algorithm>

namespace knittsim::formats::sintral {

namespace {

constexpr std::size_t kMaxSymbolsInSet = 64;
constexpr std::size_t kMaxSystems = 64;

bool allSymbols(std::string_view text) {
    return !text.empty() && text.size() <= kMaxSymbolsInSet &&
           std::all_of(text.begin(), text.end(), isSymbol);
}

bool isPattern(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c == 'I' || c == '.'; });
}

std::string withoutBlanks(std::string_view text) {
    std::string result;
    std::copy_if(text.begin(), text.end(), std::back_inserter(result), [](char c) { return !isBlank(c); });
    return result;
}

/// "(6)" at the end names an entry of the stitch table.
bool takeStitch(std::string_view& text, int& stitch) {
    if (text.empty() || text.back() != ')') {
        return true;
    }
    const std::size_t open = text.rfind('(');
    if (open == std::string_view::npos) {
        return false;
    }
    stitch = smallNumber(text.substr(open + 1, text.size() - open - 2));
    text = text.substr(0, open);
    return stitch > 0;
}

std::optional<Selection> parseSelection(std::string_view text) {
    Selection selection;
    if (!takeStitch(text, selection.stitch)) {
        return std::nullopt;
    }
    using Kind = Selection::Kind;
    if (text == "R" || text == "P" || text == "0") {
        selection.kind = text == "R" ? Kind::Knit : text == "P" ? Kind::Tuck : Kind::None;
        return selection;
    }
    if (text.size() > 1 && text[0] == 'D' && isPattern(text.substr(1))) {
        selection.kind = Kind::Pattern;
        selection.text = text.substr(1);
        return selection;
    }
    selection.kind = Kind::Symbols;
    // N is a word here, also where a symbol N exists.
    selection.others = text.size() > 1 && text[0] == 'N';
    text.remove_prefix(selection.others ? 1 : 0);
    const std::size_t percent = text.find('%');
    selection.text = text.substr(0, percent);
    const bool good = selection.text.empty() ? percent != std::string_view::npos && !selection.others
                                             : allSymbols(selection.text);
    if (percent != std::string_view::npos) {
        selection.tucks = text.substr(percent + 1);
    }
    const bool tucksGood = percent == std::string_view::npos || allSymbols(selection.tucks);
    return good && tucksGood ? std::optional(std::move(selection)) : std::nullopt;
}

bool parseBeds(std::string_view text, SystemEntry& entry) {
    const std::size_t dash = text.find('-');
    if (dash == std::string_view::npos) {
        return false;
    }
    const auto front = parseSelection(text.substr(0, dash));
    const auto rear = parseSelection(text.substr(dash + 1));
    if (!front || !rear) {
        return false;
    }
    entry.front = *front;
    entry.rear = *rear;
    return true;
}

bool parseEntry(std::string_view text, SystemEntry& entry) {
    using Kind = SystemEntry::Kind;
    if (takePrefix(text, "U^S")) {
        entry.kind = Kind::ToRear;
    } else if (takePrefix(text, "UVS")) {
        entry.kind = Kind::ToFront;
    } else if (takePrefix(text, "UXS")) {
        entry.kind = Kind::Both;
    }
    if (entry.kind == Kind::Stitch || entry.kind == Kind::Both) {
        return parseBeds(text, entry);
    }
    const auto selection = parseSelection(text);
    if (!selection) {
        return false;
    }
    (entry.kind == Kind::ToRear ? entry.front : entry.rear) = *selection;
    return true;
}

/// Takes "<1+>", "<1->" and "<A>" from the beginning.
bool takeSteps(std::string_view& text, SystemList& list) {
    while (takePrefix(text, "<")) {
        const std::size_t end = text.find('>');
        if (end == std::string_view::npos || end == 0) {
            return false;
        }
        const std::string_view word = text.substr(0, end);
        text.remove_prefix(end + 1);
        if (word.size() == 1 && word[0] >= 'A' && word[0] <= 'Z') {
            list.field = true;
            continue;
        }
        const int rows = smallNumber(word.substr(0, word.size() - 1));
        if (rows < 0 || (word.back() != '+' && word.back() != '-')) {
            return false;
        }
        list.rowStep += word.back() == '+' ? rows : -rows;
    }
    return true;
}

} // namespace

Need Selection::at(int needle, char symbol) const {
    switch (kind) {
    case Kind::None:
        return Need::None;
    case Kind::Knit:
        return Need::Knit;
    case Kind::Tuck:
        return Need::Tuck;
    case Kind::Pattern: {
        const int size = static_cast<int>(text.size());
        const int place = ((needle - 1) % size + size) % size;
        return text[static_cast<std::size_t>(place)] == 'I' ? Need::Knit : Need::None;
    }
    case Kind::Symbols:
        break;
    }
    if (symbol == 0) {
        return Need::None;
    }
    if (tucks.find(symbol) != std::string::npos) {
        return Need::Tuck;
    }
    const bool listed = text.find(symbol) != std::string::npos;
    return listed != others ? Need::Knit : Need::None;
}

std::optional<SystemList> parseSystems(std::string_view text, std::string_view& wrong) {
    SystemList list;
    wrong = text;
    const std::string plain = withoutBlanks(text);
    std::string_view rest = plain;
    if (!takeSteps(rest, list)) {
        return std::nullopt;
    }
    while (!rest.empty()) {
        const std::string_view part = takePart(rest, '/');
        SystemEntry entry;
        if (!parseEntry(part, entry) || list.entries.size() == kMaxSystems) {
            return std::nullopt;
        }
        list.entries.push_back(std::move(entry));
    }
    return list;
}

} // namespace knittsim::formats::sintral

#pragma once

#include "core/base/result.h"
#include "core/yarn/yarn.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace knittsim::yarn {

/// Yarns of one folder (resources/yarns/*.json), sorted by id. One file holds one yarn.
class YarnLibrary {
public:
    /// Reads every *.json. A bad file is left out and reported as a warning; no file at all is an error.
    static Result<YarnLibrary> read(const std::filesystem::path& folder);

    explicit YarnLibrary(std::vector<Yarn> yarns);

    const std::vector<Yarn>& yarns() const { return m_yarns; }

    /// The yarn with this id, or nullptr.
    const Yarn* find(std::string_view id) const;

private:
    std::vector<Yarn> m_yarns;
};

/// Reads and checks one yarn. Errors: KS0001, KS0007, KS0003..KS0005 with the JSON key.
Result<Yarn> readYarn(const std::filesystem::path& path);
Result<Yarn> parseYarn(std::string_view json, const std::string& file);

/// One yarn, or a library in one file: {"yarns": [yarn, ...]}. All of them or none. Errors: as above.
Result<std::vector<Yarn>> parseYarns(std::string_view json, const std::string& file);
Result<std::vector<Yarn>> readYarns(const std::filesystem::path& path);

/// A library in one file, for parseYarns(): sorted by id, so that a version control shows what changed.
std::string toJson(std::vector<Yarn> yarns);

/// The yarn as JSON text, keys in the order of the files in resources/yarns.
std::string toJson(const Yarn& yarn);

/// A middling merino yarn, used where no library is at hand.
Yarn defaultYarn();

} // namespace knittsim::yarn

#include "core/formats/knitout/reader.h"

#include "core/base/file.h"
#include "core/base/text_check.h"
#include "core/formats/knitout/header_reader.h"
#include "core/formats/knitout/operation_reader.h"
#include "core/formats/problems.h"
#include "core/formats/text.h"
#include "core/formats/text_lines.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace knittsim::formats::knitout {

namespace {

constexpr std::string_view kMagic = ";!knitout-";
constexpr std::string_view kSource = ";!source:";
constexpr int kKnownVersion = 2;
constexpr int kMaxVersion = 1'000'000;

bool startsWith(std::string_view text, std::string_view prefix) {
    return text.substr(0, prefix.size()) == prefix;
}

/// The version of a line ';!knitout-2', or nothing.
std::optional<int> versionIn(std::string_view line) {
    if (!startsWith(line, kMagic)) {
        return std::nullopt;
    }
    const std::optional<std::int64_t> version = parseInteger(trim(line.substr(kMagic.size())));
    if (!version || *version < 0 || *version > kMaxVersion) {
        return std::nullopt;
    }
    return static_cast<int>(*version);
}

class Reader {
public:
    Reader(std::string_view text, const std::string& file)
        : m_text(text), m_problems(file, kMaxProblems), m_header(m_program.header, m_problems),
          m_operations(m_program, m_problems) {
        m_program.file = file;
    }

    Result<machine::Program> run();

private:
    void checkFirstLine();
    void readMagic(std::string_view line);
    void readLine(std::string_view line);
    void readHeaderLine(const HeaderLine& header);
    void readBody(std::string_view line);
    void beginBody();
    void checkEnd();
    bool tooMany();

    std::string_view m_text;
    machine::Program m_program;
    Problems m_problems;
    HeaderReader m_header;
    OperationReader m_operations;
    int m_line = 0;
    bool m_magic = false;
    bool m_headerEnded = false; ///< by a line that is no header line
    bool m_inBody = false;      ///< an operation was seen
    bool m_saidSplitHeader = false;
};

Result<machine::Program> Reader::run() {
    checkFirstLine();
    TextLines lines(m_text, m_problems);
    while (lines.next()) {
        m_line = lines.number();
        readLine(lines.line());
        if (tooMany()) {
            break;
        }
    }
    m_line = lines.number();
    checkEnd();
    if (m_problems.errorCount() > 0) {
        return Result<machine::Program>::failure(m_problems.take());
    }
    return {std::move(m_program), m_problems.take()};
}

/// Says so when the first line is not the magic line.
void Reader::checkFirstLine() {
    const std::string_view text = withoutByteOrderMark(m_text);
    std::string_view line = text.substr(0, text.find('\n'));
    if (!line.empty() && line.back() == '\r') {
        line.remove_suffix(1);
    }
    if (!versionIn(line)) {
        m_problems.warn("KS0101", {1, 1}, {quoted(line)});
    }
}

/// Takes the version of a magic line. A later one counts only where the first line is none.
void Reader::readMagic(std::string_view line) {
    const std::optional<int> version = versionIn(line);
    if (!version || m_magic) {
        return;
    }
    m_magic = true;
    m_program.header.version = *version;
    if (*version > kKnownVersion) {
        m_problems.warn("KS0102", {m_line, static_cast<int>(kMagic.size()) + 1}, {std::to_string(*version)});
    }
}

void Reader::readLine(std::string_view line) {
    if (startsWith(line, ";;")) {
        if (const auto header = splitHeader(line)) {
            readHeaderLine(*header);
        }
        return;
    }
    if (startsWith(line, kMagic) && !m_inBody) {
        readMagic(line);
        return;
    }
    m_headerEnded = true;
    readBody(line);
}

void Reader::readHeaderLine(const HeaderLine& header) {
    if (m_inBody) {
        if (isKnownHeader(header.name)) {
            m_problems.warn("KS0106", {m_line, 1}, {shown(header.name)});
        }
        return;
    }
    if (m_headerEnded) {
        if (!isKnownHeader(header.name)) {
            return;
        }
        if (!std::exchange(m_saidSplitHeader, true)) {
            m_problems.warn("KS0123", {m_line, 1}, {shown(header.name)});
        }
    }
    m_header.read(header, m_line);
}

void Reader::readBody(std::string_view line) {
    const std::size_t semicolon = line.find(';');
    const std::string_view operation = line.substr(0, semicolon);
    if (semicolon != std::string_view::npos && startsWith(line.substr(semicolon), kSource)) {
        m_program.sourceComments.emplace_back(
            static_cast<machine::OperationIndex>(m_program.operations.size()), line.substr(semicolon));
    }
    if (!trim(operation).empty()) {
        beginBody();
        m_operations.read(operation, m_line);
    }
}

void Reader::beginBody() {
    if (std::exchange(m_inBody, true)) {
        return;
    }
    m_header.finish();
    if (!m_header.sawCarriers()) {
        m_operations.setCarriers(OperationReader::Carriers::Missing);
    } else if (m_program.header.carriers.empty()) {
        m_operations.setCarriers(OperationReader::Carriers::Faulty);
    }
}

bool Reader::tooMany() {
    if (m_program.operations.size() + m_program.sourceComments.size() <= kMaxOperations) {
        return false;
    }
    m_problems.error("KS0125", {m_line, 1}, {std::to_string(kMaxOperations)});
    return true;
}

void Reader::checkEnd() {
    if (!m_inBody) {
        m_header.finish();
    }
    if (!m_inBody && m_problems.errorCount() == 0) {
        // A knitout file may be empty; a file with neither magic nor operation is something else.
        m_problems.add(m_magic ? Severity::Warning : Severity::Error, "KS0121", {std::max(m_line, 1), 1}, {});
    }
    if (!m_header.sawCarriers() && m_problems.errorCount() == 0) {
        m_problems.warn("KS0103", {1, 1});
    }
}

} // namespace

Result<machine::Program> parse(std::string_view text, const std::string& file) {
    return Reader(text, file).run();
}

Result<machine::Program> read(const std::filesystem::path& path) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) {
        return Result<machine::Program>::failure(bytes.diagnostics());
    }
    return parse(bytes.value(), path.string());
}

} // namespace knittsim::formats::knitout

#include "core/pattern/chart_edit.h"

#include "core/pattern/program_course.h"

#include <algorithm>
#include <cstdlib>

namespace knittsim::pattern {

namespace {

bool isIn(const Chart& chart, CellPlace p) {
    return p.wale >= 0 && p.wale < chart.width && p.course >= 0 && p.course < chart.height();
}

/// What the front shows of a stitch.
Stitch onOneBed(Stitch stitch) {
    switch (stitch) {
    case Stitch::Both:
    case Stitch::KnitTuck:
        return Stitch::Knit;
    case Stitch::TuckKnit:
    case Stitch::TuckBoth:
    case Stitch::RearTuck:
        return Stitch::Tuck;
    case Stitch::RearMiss:
        return Stitch::Miss;
    default:
        return stitch;
    }
}

/// Of a course, the moves that have nothing to do with these wales.
void dropMoves(Course& course, int first, int end) {
    const auto touches = [&](int wale) { return wale >= first && wale < end; };
    std::erase_if(course.moves, [&](const LoopMove& move) { return touches(move.from) || touches(move.to); });
}

void dropMoves(Chart& chart, CellRange range) {
    for (int c = range.course; c < range.course + range.height; ++c) {
        dropMoves(chart.course(c), range.wale, range.wale + range.width);
    }
}

/// A part of a course's settings that belongs to a copied course: what a program does on its own needles does
/// not.
Course withMoves(const Course& course, std::vector<LoopMove> moves) {
    Course copy = course;
    copy.moves = std::move(moves);
    copy.program = nullptr;
    return copy;
}

} // namespace

CellRange rangeOf(CellPlace a, CellPlace b) {
    return {std::min(a.wale, b.wale), std::min(a.course, b.course), std::abs(a.wale - b.wale) + 1,
            std::abs(a.course - b.course) + 1};
}

CellRange inside(const Chart& chart, CellRange range) {
    const int right = std::min(range.wale + range.width, chart.width);
    const int top = std::min(range.course + range.height, chart.height());
    const int left = std::max(range.wale, 0);
    const int bottom = std::max(range.course, 0);
    return {left, bottom, std::max(0, right - left), std::max(0, top - bottom)};
}

std::vector<CellPlace> lineOf(CellPlace from, CellPlace to) {
    const int across = std::abs(to.wale - from.wale);
    const int up = std::abs(to.course - from.course);
    const int stepAcross = from.wale < to.wale ? 1 : -1;
    const int stepUp = from.course < to.course ? 1 : -1;
    std::vector<CellPlace> line{from};
    line.reserve(static_cast<std::size_t>(std::max(across, up)) + 1);
    int error = across - up;
    while (from != to) {
        const int twice = 2 * error;
        if (twice > -up) {
            error -= up;
            from.wale += stepAcross;
        }
        if (twice < across) {
            error += across;
            from.course += stepUp;
        }
        line.push_back(from);
    }
    return line;
}

void paint(Chart& chart, std::span<const CellPlace> places, const Brush& brush) {
    for (const CellPlace& p : places) {
        if (isIn(chart, p)) {
            brush.paint(chart.at(p.wale, p.course));
        }
    }
}

void paintRange(Chart& chart, CellRange range, const Brush& brush, bool outlineOnly) {
    const CellRange whole = range;
    range = inside(chart, range);
    for (int c = range.course; c < range.course + range.height; ++c) {
        for (int w = range.wale; w < range.wale + range.width; ++w) {
            const bool rim = c == whole.course || c == whole.course + whole.height - 1 || w == whole.wale ||
                             w == whole.wale + whole.width - 1;
            if (rim || !outlineOnly) {
                brush.paint(chart.at(w, c));
            }
        }
    }
}

void fill(Chart& chart, CellPlace from, const Brush& brush) {
    if (!isIn(chart, from)) {
        return;
    }
    const Cell old = chart.at(from.wale, from.course);
    Cell painted = old;
    brush.paint(painted);
    if (painted == old) {
        return;
    }
    std::vector<CellPlace> open{from};
    while (!open.empty()) {
        const CellPlace p = open.back();
        open.pop_back();
        if (!isIn(chart, p) || chart.at(p.wale, p.course) != old) {
            continue;
        }
        chart.at(p.wale, p.course) = painted;
        open.insert(
            open.end(),
            {{p.wale - 1, p.course}, {p.wale + 1, p.course}, {p.wale, p.course - 1}, {p.wale, p.course + 1}});
    }
}

Chart copyOf(const Chart& chart, CellRange range) {
    range = inside(chart, range);
    Chart part(range.width, range.height);
    part.beds = chart.beds;
    part.yarns = chart.yarns;
    for (int c = 0; c < range.height; ++c) {
        const Course& course = chart.course(range.course + c);
        std::vector<LoopMove> moves;
        for (const LoopMove& move : course.moves) {
            if (range.contains({move.from, range.course}) && range.contains({move.to, range.course})) {
                moves.push_back({move.from - range.wale, move.to - range.wale});
            }
        }
        part.course(c) = withMoves(course, std::move(moves));
        for (int w = 0; w < range.width; ++w) {
            part.at(w, c) = chart.at(range.wale + w, range.course + c);
        }
    }
    return part;
}

void paste(Chart& chart, CellPlace at, const Chart& part, PasteWhat what) {
    const CellRange range = inside(chart, {at.wale, at.course, part.width, part.height()});
    dropMoves(chart, range);
    const bool single = chart.beds == BedUse::Single;
    for (int c = range.course; c < range.course + range.height; ++c) {
        for (const LoopMove& move : part.course(c - at.course).moves) {
            const LoopMove here{move.from + at.wale, move.to + at.wale};
            if (single && range.contains({here.from, c}) && range.contains({here.to, c})) {
                chart.course(c).moves.push_back(here);
            }
        }
        for (int w = range.wale; w < range.wale + range.width; ++w) {
            const Cell& from = part.at(w - at.wale, c - at.course);
            Cell& cell = chart.at(w, c);
            cell.stitch = single ? onOneBed(from.stitch) : from.stitch;
            if (what == PasteWhat::Everything) {
                cell.yarn = from.yarn < chart.yarns.size() ? from.yarn : std::uint8_t{0};
            }
        }
    }
}

void tile(Chart& chart, CellRange range, const Chart& part, PasteWhat what) {
    range = inside(chart, range);
    if (range.empty() || part.width < 1 || part.height() < 1) {
        return;
    }
    for (int c = 0; c < range.height; c += part.height()) {
        for (int w = 0; w < range.width; w += part.width) {
            const CellRange cut{0, 0, std::min(part.width, range.width - w),
                                std::min(part.height(), range.height - c)};
            paste(chart, {range.wale + w, range.course + c}, copyOf(part, cut), what);
        }
    }
}

void repeatOver(Chart& chart, CellRange range, CellRange source) {
    source = inside(chart, source);
    range = inside(chart, range);
    if (source.empty() || range.empty()) {
        return;
    }
    const Chart part = copyOf(chart, source);
    const auto firstOf = [](int at, int size, int from) { // of the repeats that reach into the range
        const int before = at > from ? (at - from + size - 1) / size : -((from - at) / size);
        return at - before * size;
    };
    const int left = firstOf(source.wale, source.width, range.wale);
    for (int c = firstOf(source.course, source.height, range.course); c < range.course + range.height;
         c += source.height) {
        for (int w = left; w < range.wale + range.width; w += source.width) {
            const int wale = std::max(w, range.wale);
            const int course = std::max(c, range.course);
            const CellRange cut{wale - w, course - c,
                                std::min(w + source.width, range.wale + range.width) - wale,
                                std::min(c + source.height, range.course + range.height) - course};
            paste(chart, {wale, course}, copyOf(part, cut));
        }
    }
}

void clear(Chart& chart, CellRange range) {
    range = inside(chart, range);
    dropMoves(chart, range);
    paintRange(chart, range, {Stitch::Knit, std::nullopt});
}

void mirror(Chart& chart, CellRange range, Mirror how) {
    range = inside(chart, range);
    Chart part = copyOf(chart, range);
    if (how == Mirror::LeftRight) {
        for (int c = 0; c < part.height(); ++c) {
            for (int w = 0; w < part.width / 2; ++w) {
                std::swap(part.at(w, c), part.at(part.width - 1 - w, c));
            }
            for (LoopMove& move : part.course(c).moves) {
                move = {part.width - 1 - move.from, part.width - 1 - move.to};
            }
        }
    } else {
        for (int c = 0; c < part.height() / 2; ++c) {
            std::swap(part.course(c), part.course(part.height() - 1 - c));
            for (int w = 0; w < part.width; ++w) {
                std::swap(part.at(w, c), part.at(w, part.height() - 1 - c));
            }
        }
    }
    paste(chart, {range.wale, range.course}, part);
}

bool rotate(Chart& chart, CellRange range) {
    if (range != inside(chart, range) || range.width != range.height) {
        return false;
    }
    const Chart part = copyOf(chart, range);
    dropMoves(chart, range);
    for (int c = 0; c < range.height; ++c) {
        for (int w = 0; w < range.width; ++w) {
            chart.at(range.wale + c, range.course + range.width - 1 - w) = part.at(w, c);
        }
    }
    return true;
}

void shift(Chart& chart, CellRange range, int wales, int courses) {
    range = inside(chart, range);
    if (range.empty()) {
        return;
    }
    const Chart part = copyOf(chart, range);
    const auto wrapped = [](int value, int size) { return ((value % size) + size) % size; };
    dropMoves(chart, range);
    for (int c = 0; c < range.height; ++c) {
        const int toCourse = range.course + wrapped(c + courses, range.height);
        for (const LoopMove& move : part.course(c).moves) {
            const LoopMove moved{range.wale + wrapped(move.from + wales, range.width),
                                 range.wale + wrapped(move.to + wales, range.width)};
            if (moved.to - moved.from == move.to - move.from) { // else it has come apart at the edge
                chart.course(toCourse).moves.push_back(moved);
            }
        }
        for (int w = 0; w < range.width; ++w) {
            chart.at(range.wale + wrapped(w + wales, range.width), toCourse) = part.at(w, c);
        }
    }
}

void insertCourses(Chart& chart, int course, int count) {
    course = std::clamp(course, 0, chart.height());
    count = std::clamp(count, 0, kMaxCourses - chart.height());
    if (count == 0) {
        return;
    }
    const int like = std::min(course, chart.height() - 1);
    const auto row = chart.cells.begin() + static_cast<std::ptrdiff_t>(like) * chart.width;
    const std::vector<Cell> cells(row, row + chart.width);
    const Course settings = withMoves(chart.course(like), {});
    chart.courses.insert(chart.courses.begin() + course, static_cast<std::size_t>(count), settings);
    std::vector<Cell> rows;
    rows.reserve(cells.size() * static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        rows.insert(rows.end(), cells.begin(), cells.end());
    }
    chart.cells.insert(chart.cells.begin() + static_cast<std::ptrdiff_t>(course) * chart.width, rows.begin(),
                       rows.end());
}

void removeCourses(Chart& chart, int course, int count) {
    course = std::clamp(course, 0, chart.height() - 1);
    count = std::clamp(count, 0, std::min(chart.height() - course, chart.height() - 1));
    chart.courses.erase(chart.courses.begin() + course, chart.courses.begin() + course + count);
    const auto first = chart.cells.begin() + static_cast<std::ptrdiff_t>(course) * chart.width;
    chart.cells.erase(first, first + static_cast<std::ptrdiff_t>(count) * chart.width);
}

void insertWales(Chart& chart, int wale, int count) {
    wale = std::clamp(wale, 0, chart.width);
    count = std::clamp(count, 0, kMaxWales - chart.width);
    const int like = std::min(wale, chart.width - 1);
    std::vector<Cell> cells;
    cells.reserve(static_cast<std::size_t>(chart.width + count) * chart.courses.size());
    for (int c = 0; c < chart.height(); ++c) {
        for (int w = 0; w < chart.width + count; ++w) {
            cells.push_back(chart.at(w < wale ? w : w < wale + count ? like : w - count, c));
        }
        for (LoopMove& move : chart.course(c).moves) {
            move.from += move.from >= wale ? count : 0;
            move.to += move.to >= wale ? count : 0;
        }
        if (const auto& program = chart.course(c).program) {
            chart.course(c).program = withWales(*program, wale, count);
        }
    }
    chart.cells = std::move(cells);
    chart.width += count;
}

void removeWales(Chart& chart, int wale, int count) {
    wale = std::clamp(wale, 0, chart.width - 1);
    count = std::clamp(count, 0, std::min(chart.width - wale, chart.width - 1));
    std::vector<Cell> cells;
    cells.reserve(static_cast<std::size_t>(chart.width - count) * chart.courses.size());
    for (int c = 0; c < chart.height(); ++c) {
        for (int w = 0; w < chart.width; ++w) {
            if (w < wale || w >= wale + count) {
                cells.push_back(chart.at(w, c));
            }
        }
        dropMoves(chart.course(c), wale, wale + count);
        for (LoopMove& move : chart.course(c).moves) {
            move.from -= move.from >= wale ? count : 0;
            move.to -= move.to >= wale ? count : 0;
        }
        if (const auto& program = chart.course(c).program) {
            chart.course(c).program = withoutWales(*program, wale, count);
        }
    }
    chart.cells = std::move(cells);
    chart.width -= count;
}

bool bindOff(Chart& chart) {
    std::vector<int> held; // wales, from the right
    std::uint8_t yarn = 0;
    for (int w = chart.width - 1; w >= 0 && chart.height() > 0; --w) {
        const Cell cell = chart.at(w, chart.height() - 1);
        if (cell.stitch != Stitch::Empty && cell.stitch != Stitch::Drop) {
            held.push_back(w);
            yarn = isWorked(cell.stitch) ? cell.yarn : yarn;
        }
    }
    if (chart.beds == BedUse::Double || held.size() < 2 ||
        chart.height() + static_cast<int>(held.size()) > kMaxCourses) {
        return false;
    }
    for (std::size_t i = 0; i + 1 < held.size(); ++i) {
        const int course = chart.height();
        chart.cells.resize(chart.cells.size() + static_cast<std::size_t>(chart.width), {Stitch::Empty, 0});
        chart.courses.emplace_back().moves = {{held[i], held[i + 1]}};
        chart.at(held[i + 1], course) = {Stitch::Knit, yarn};
        for (std::size_t k = i + 2; k < held.size(); ++k) {
            chart.at(held[k], course).stitch = Stitch::Rest;
        }
    }
    return true;
}

bool useBeds(Chart& chart, BedUse beds) {
    const bool moves = std::ranges::any_of(chart.courses, [](const Course& c) { return !c.moves.empty(); });
    if (chart.beds == beds || moves) {
        return chart.beds == beds;
    }
    chart.beds = beds;
    if (beds == BedUse::Double) {
        nameRearBeds(chart);
        return true;
    }
    for (Cell& cell : chart.cells) {
        cell.stitch = onOneBed(cell.stitch);
    }
    for (Course& course : chart.courses) {
        course.rack = 0;
        course.colours = isBacked(course.colours) ? ColourMethod::Float : course.colours;
    }
    return true;
}

void nameRearBeds(Chart& chart) {
    for (int wale = 0; wale < chart.width; ++wale) {
        bool front = false;
        bool rear = false;
        for (int c = 0; c < chart.height(); ++c) {
            Stitch& stitch = chart.at(wale, c).stitch;
            if (rear && !front && !isAsInProgram(chart, wale, c)) {
                stitch = stitch == Stitch::Tuck   ? Stitch::RearTuck
                         : stitch == Stitch::Miss ? Stitch::RearMiss
                                                  : stitch;
            }
            front = front || stitch == Stitch::Knit || stitch == Stitch::Both || stitch == Stitch::Tuck;
            rear = rear || stitch == Stitch::Purl || stitch == Stitch::Both;
        }
    }
}

ChartPatch::ChartPatch(const Chart& before, const Chart& after) {
    const auto sameCourse = [&](int a, int b) {
        const auto row = [](const Chart& chart, int c) {
            return chart.cells.begin() + static_cast<std::ptrdiff_t>(c) * chart.width;
        };
        return before.course(a) == after.course(b) &&
               std::equal(row(before, a), row(before, a + 1), row(after, b));
    };
    int endBefore = before.height();
    int endAfter = after.height();
    if (before.width == after.width) {
        const int least = std::min(endBefore, endAfter);
        while (m_first < least && sameCourse(m_first, m_first)) {
            ++m_first;
        }
        while (endBefore > m_first && endAfter > m_first && sameCourse(endBefore - 1, endAfter - 1)) {
            --endBefore;
            --endAfter;
        }
    }
    m_before = partOf(before, endBefore);
    m_after = partOf(after, endAfter);
}

ChartPatch::Part ChartPatch::partOf(const Chart& chart, int end) const {
    const auto row = [&](int c) {
        return chart.cells.begin() + static_cast<std::ptrdiff_t>(c) * chart.width;
    };
    return {chart.width,
            chart.beds,
            chart.yarns,
            {row(m_first), row(end)},
            {chart.courses.begin() + m_first, chart.courses.begin() + end}};
}

void ChartPatch::replace(Chart& chart, const Part& from, const Part& to) const {
    const auto firstCell = chart.cells.begin() + static_cast<std::ptrdiff_t>(m_first) * from.width;
    const auto firstCourse = chart.courses.begin() + m_first;
    const auto at = chart.cells.erase(firstCell, firstCell + static_cast<std::ptrdiff_t>(from.cells.size()));
    chart.cells.insert(at, to.cells.begin(), to.cells.end());
    const auto course =
        chart.courses.erase(firstCourse, firstCourse + static_cast<std::ptrdiff_t>(from.courses.size()));
    chart.courses.insert(course, to.courses.begin(), to.courses.end());
    chart.width = to.width;
    chart.beds = to.beds;
    chart.yarns = to.yarns;
}

} // namespace knittsim::pattern

#include "core/pattern/picture_chart.h"

#include "core/pattern/ok_lab.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace knittsim::pattern {

namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

bool goesOn(const Progress& progress, double share) {
    return !progress || progress(share);
}

/// Light of the cells, row after row from the top.
class Averaging {
public:
    Averaging(const Picture& picture, int columns, int rows)
        : m_picture(picture), m_columns(columns), m_rows(rows) {
        for (int i = 0; i < 256; ++i) {
            m_linear[at(i)] = linearOf(static_cast<std::uint8_t>(i));
        }
    }

    std::vector<LinearRgb> run(const Progress& progress) const {
        std::vector<LinearRgb> cells;
        cells.reserve(at(m_columns) * at(m_rows));
        for (int row = 0; row < m_rows; ++row) {
            if (!goesOn(progress, 0.6 * row / m_rows)) {
                return {};
            }
            for (int column = 0; column < m_columns; ++column) {
                cells.push_back(meanOf(column, row));
            }
        }
        return cells;
    }

private:
    LinearRgb meanOf(int column, int row) const {
        const double left = double(column) * m_picture.width / m_columns;
        const double right = double(column + 1) * m_picture.width / m_columns;
        const double top = double(row) * m_picture.height / m_rows;
        const double bottom = double(row + 1) * m_picture.height / m_rows;
        LinearRgb sum{};
        double area = 0;
        for (int y = int(top); y < std::min(m_picture.height, int(std::ceil(bottom))); ++y) {
            const double high = std::min(bottom, y + 1.0) - std::max(top, double(y));
            for (int x = int(left); x < std::min(m_picture.width, int(std::ceil(right))); ++x) {
                const double part = high * (std::min(right, x + 1.0) - std::max(left, double(x)));
                const std::size_t pixel = (at(y) * at(m_picture.width) + at(x)) * 3;
                for (std::size_t i = 0; i < 3; ++i) {
                    sum[i] += part * m_linear[m_picture.rgb[pixel + i]];
                }
                area += part;
            }
        }
        for (double& channel : sum) {
            channel /= area;
        }
        return sum;
    }

    const Picture& m_picture;
    int m_columns;
    int m_rows;
    std::array<double, 256> m_linear{};
};

std::size_t nearest(const std::vector<OkLab>& colours, const OkLab& wanted) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < colours.size(); ++i) {
        if (squaredDistance(colours[i], wanted) < squaredDistance(colours[best], wanted)) {
            best = i;
        }
    }
    return best;
}

/// The colours that fit best: groups of cells split in two, the widest first, then k-means.
class Palette {
public:
    explicit Palette(const std::vector<LinearRgb>& cells) : m_cells(cells) {
        m_labs.reserve(cells.size());
        for (const LinearRgb& cell : cells) {
            m_labs.push_back(okLabOf(cell));
        }
    }

    std::vector<yarn::Colour> find(int count, const Progress& progress) {
        split(at(count));
        constexpr int kRounds = 16;
        for (int round = 0; round < kRounds; ++round) {
            if (!goesOn(progress, 0.6 + 0.3 * round / kRounds) || !settle()) {
                break;
            }
        }
        return colours();
    }

private:
    struct Spread {
        std::size_t axis = 0;
        double mean = 0;
        double squares = 0; ///< sum of squared distances from the mean along the axis
    };

    Spread spreadOf(const std::vector<std::size_t>& group) const {
        Spread widest;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double mean = 0;
            for (const std::size_t i : group) {
                mean += m_labs[i][axis] / static_cast<double>(group.size());
            }
            double squares = 0;
            for (const std::size_t i : group) {
                squares += (m_labs[i][axis] - mean) * (m_labs[i][axis] - mean);
            }
            if (axis == 0 || squares > widest.squares) {
                widest = {axis, mean, squares};
            }
        }
        return widest;
    }

    void split(std::size_t count) {
        std::vector<std::vector<std::size_t>> groups(1);
        groups[0].resize(m_cells.size());
        std::iota(groups[0].begin(), groups[0].end(), std::size_t{0});
        while (groups.size() < count) {
            std::size_t widest = 0;
            std::vector<Spread> spreads;
            for (const auto& group : groups) {
                spreads.push_back(spreadOf(group));
                widest = spreads.back().squares > spreads[widest].squares ? spreads.size() - 1 : widest;
            }
            const Spread& spread = spreads[widest];
            if (spread.squares < 1e-9) {
                break; // no more colours than these
            }
            const auto middle = std::ranges::partition(
                groups[widest], [&](std::size_t i) { return m_labs[i][spread.axis] < spread.mean; });
            std::vector<std::size_t> upper(middle.begin(), middle.end());
            groups[widest].erase(middle.begin(), middle.end());
            groups.push_back(std::move(upper));
        }
        m_group.assign(m_cells.size(), 0);
        for (std::size_t g = 0; g < groups.size(); ++g) {
            for (const std::size_t i : groups[g]) {
                m_group[i] = g;
            }
        }
        m_count = groups.size();
    }

    std::vector<OkLab> centres() const {
        std::vector<OkLab> sums(m_count);
        std::vector<double> sizes(m_count, 0);
        for (std::size_t i = 0; i < m_labs.size(); ++i) {
            sizes[m_group[i]] += 1;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                sums[m_group[i]][axis] += m_labs[i][axis];
            }
        }
        for (std::size_t g = 0; g < m_count; ++g) {
            for (double& value : sums[g]) {
                value /= std::max(sizes[g], 1.0);
            }
        }
        return sums;
    }

    /// One round of k-means; false when nothing changed.
    bool settle() {
        const std::vector<OkLab> middles = centres();
        bool changed = false;
        for (std::size_t i = 0; i < m_labs.size(); ++i) {
            const std::size_t own = nearest(middles, m_labs[i]);
            changed = changed || own != m_group[i];
            m_group[i] = own;
        }
        return changed;
    }

    /// Mean light of each group, the largest first.
    std::vector<yarn::Colour> colours() const {
        std::vector<LinearRgb> sums(m_count);
        std::vector<std::size_t> sizes(m_count, 0);
        for (std::size_t i = 0; i < m_cells.size(); ++i) {
            ++sizes[m_group[i]];
            for (std::size_t channel = 0; channel < 3; ++channel) {
                sums[m_group[i]][channel] += m_cells[i][channel];
            }
        }
        std::vector<std::size_t> order(m_count);
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
        std::vector<yarn::Colour> found;
        for (const std::size_t g : order) {
            if (sizes[g] > 0) {
                for (double& channel : sums[g]) {
                    channel /= static_cast<double>(sizes[g]);
                }
                found.push_back(colourOf(sums[g]));
            }
        }
        return found;
    }

    const std::vector<LinearRgb>& m_cells;
    std::vector<OkLab> m_labs;
    std::vector<std::size_t> m_group; ///< by cell
    std::size_t m_count = 0;
};

/// Colours of the cells, row after row from the top; the light that a colour lacks goes to the neighbours.
std::vector<std::uint8_t> match(std::vector<LinearRgb> cells, int columns,
                                const std::vector<yarn::Colour>& colours, bool dither) {
    std::vector<LinearRgb> lights;
    std::vector<OkLab> labs;
    for (const yarn::Colour& colour : colours) {
        lights.push_back(linearOf(colour));
        labs.push_back(okLabOf(lights.back()));
    }
    std::vector<std::uint8_t> found(cells.size());
    const int rows = static_cast<int>(cells.size()) / columns;
    const auto give = [&](int column, int row, const LinearRgb& error, double share) {
        if (column >= 0 && column < columns && row < rows) {
            for (std::size_t i = 0; i < 3; ++i) {
                cells[at(row) * at(columns) + at(column)][i] += share * error[i];
            }
        }
    };
    for (int row = 0; row < rows; ++row) {
        // There and back, so that no slanting lines appear.
        const int way = row % 2 == 0 ? 1 : -1;
        for (int step = 0; step < columns; ++step) {
            const int column = way > 0 ? step : columns - 1 - step;
            const std::size_t cell = at(row) * at(columns) + at(column);
            // Errors may add up beyond what can be seen; of a colour that no mixture gives, not for ever.
            LinearRgb wanted = cells[cell];
            LinearRgb seen = wanted;
            for (std::size_t i = 0; i < 3; ++i) {
                wanted[i] = std::clamp(wanted[i], -1.0, 2.0);
                seen[i] = std::clamp(wanted[i], 0.0, 1.0);
            }
            const std::size_t best = nearest(labs, okLabOf(seen));
            found[cell] = static_cast<std::uint8_t>(best);
            if (dither) {
                LinearRgb error{};
                for (std::size_t i = 0; i < 3; ++i) {
                    error[i] = wanted[i] - lights[best][i];
                }
                give(column + way, row, error, 7.0 / 16);
                give(column - way, row + 1, error, 3.0 / 16);
                give(column, row + 1, error, 5.0 / 16);
                give(column + way, row + 1, error, 1.0 / 16);
            }
        }
    }
    return found;
}

} // namespace

int coursesFor(const Picture& picture, int wales, double stitchAspect) {
    const double courses = double(wales) * picture.height / picture.width / stitchAspect;
    return static_cast<int>(std::clamp(std::round(courses), 1.0, double(kMaxCourses)));
}

std::optional<PictureCells> reducePicture(const Picture& picture, const PictureOptions& options,
                                          const Progress& progress) {
    const std::vector<LinearRgb> cells = Averaging(picture, options.wales, options.courses).run(progress);
    if (cells.empty()) {
        return std::nullopt;
    }
    PictureCells made{options.wales, options.courses, options.colours, {}};
    if (made.colours.empty()) {
        made.colours = Palette(cells).find(options.count, progress);
    }
    if (!goesOn(progress, 0.9)) {
        return std::nullopt;
    }
    const std::vector<std::uint8_t> rows = match(cells, options.wales, made.colours, options.dither);
    for (int course = 0; course < options.courses; ++course) {
        const auto row = rows.begin() + std::ptrdiff_t{options.courses - 1 - course} * options.wales;
        made.yarns.insert(made.yarns.end(), row, row + options.wales);
    }
    return made;
}

Chart chartOf(const PictureCells& cells, const std::vector<std::string>& carriers, ColourMethod method) {
    Chart chart(cells.wales, cells.courses);
    chart.beds = isBacked(method) ? BedUse::Double : BedUse::Single;
    for (std::size_t i = 0; i < cells.colours.size(); ++i) {
        chart.yarns.push_back({carriers[i], cells.colours[i], {}});
    }
    for (std::size_t i = 0; i < chart.cells.size(); ++i) {
        chart.cells[i].yarn = cells.yarns[i];
    }
    for (Course& course : chart.courses) {
        course.colours = method;
    }
    return chart;
}

} // namespace knittsim::pattern

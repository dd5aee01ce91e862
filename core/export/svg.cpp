#include "core/export/stroke_order.h"
#include "core/export/writers.h"
#include "core/geometry/bounds.h"
#include "core/geometry/stroke_style.h"

#include <algorithm>
#include <cmath>

namespace knittsim::exports {

namespace {

constexpr std::size_t kBetweenReports = 256;

using Style = geometry::StrokeStyle;

constexpr float kMostLength = 1; ///< of a piece that is painted at once, diameters

/// How far strokes reach into each other where they meet, so that no seam is seen: the body covers the edge
/// of the piece that is painted first.
constexpr float kEdgeOverlapMm = 0.02F;
constexpr float kBodyOverlapMm = 0.04F;

std::string hex(double r, double g, double b) {
    const auto byte = [](double c) { return static_cast<int>(std::lround(std::clamp(c, 0.0, 255.0))); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(r), byte(g), byte(b));
}

class Drawing {
public:
    Drawing(Output& out, const Shape& shape, bool back) : m_out(out), m_shape(shape), m_back(back) {}

    void write() {
        open();
        const std::vector<Stroke> strokes = strokesInOrder(m_shape.curves, mostMm(), m_back);
        for (std::size_t s = 0; s < strokes.size(); ++s) {
            if (s % kBetweenReports == 0) {
                m_out.advance(static_cast<double>(s) / static_cast<double>(strokes.size()));
            }
            paint(strokes[s]);
        }
        m_out.write("</svg>\n");
    }

private:
    float mostMm() const {
        const auto thinnest = std::ranges::min_element(m_shape.materials, {}, &Material::diameterMm);
        return thinnest != m_shape.materials.end() ? kMostLength * static_cast<float>(thinnest->diameterMm)
                                                   : 1;
    }

    void open() {
        double widest = 0;
        for (const Material& material : m_shape.materials) {
            widest = std::max(widest, material.diameterMm);
        }
        geometry::Bounds box = geometry::boundsOf(m_shape.curves.nodes, static_cast<float>(widest));
        if (box.empty()) {
            box.add(Vec3f::Zero());
            box.add(Vec3f::Ones());
        }
        const Vec3f size = box.size();
        m_left = m_back ? -box.high.x() : box.low.x();
        m_top = -box.high.y();
        m_out.print("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.3f}mm\" height=\"{1:.3f}mm\" "
                    "viewBox=\"0 0 {0:.3f} {1:.3f}\">\n<title>technical {2}</title>\n<style>\n"
                    "path {{ fill: none; stroke-linejoin: round; }}\n",
                    size.x(), size.y(), m_back ? "back" : "face");
        for (std::size_t c = 0; c < m_shape.materials.size(); ++c) {
            const Material& material = m_shape.materials[c];
            const auto [r, g, b] = material.colour;
            const auto dot = [](double v) { return Style::kDotShare * v + (1 - Style::kDotShare) * 255; };
            m_out.print(
                ".e{0} {{ stroke: {1}; stroke-width: {2:.4f}; }}\n"
                ".b{0} {{ stroke: {3}; stroke-width: {4:.4f}; }}\n"
                ".d{0} {{ stroke: {5}; stroke-width: {6:.4f}; stroke-dasharray: {7:.4f} {8:.4f}; }}\n",
                c, hex(Style::kEdgeShade * r, Style::kEdgeShade * g, Style::kEdgeShade * b),
                material.diameterMm, hex(r, g, b), Style::kBodyWidth * material.diameterMm,
                hex(dot(r), dot(g), dot(b)), Style::kDotWidth * material.diameterMm,
                Style::kDotLength * material.diameterMm,
                (Style::kDotEvery - Style::kDotLength) * material.diameterMm);
        }
        m_out.write("</style>\n");
    }

    void paint(const Stroke& stroke) {
        const machine::CarrierIndex carrier = m_shape.curves.yarns[stroke.yarn].carrier;
        const double every = Style::kDotEvery * m_shape.materials[carrier].diameterMm;
        m_out.print("<path class=\"e{}\" d=\"{}\"/>", carrier, pathOf(stroke, kEdgeOverlapMm));
        m_out.print("<path class=\"b{}\" d=\"{}\"/>", carrier, pathOf(stroke, kBodyOverlapMm));
        m_out.print("<path class=\"d{}\" stroke-dashoffset=\"{:.4f}\" d=\"{}\"/>\n", carrier,
                    std::fmod(static_cast<double>(std::max(0.0F, stroke.from - kBodyOverlapMm)), every),
                    pathOf(stroke, kBodyOverlapMm));
    }

    std::string pathOf(const Stroke& stroke, float longer) const {
        const geometry::YarnCurves& curves = m_shape.curves;
        const geometry::YarnCurves::Range& yarn = curves.yarns[stroke.yarn];
        const auto begin = curves.arc.begin() + yarn.first;
        const auto end = begin + yarn.count;
        const float from = std::max(*begin, stroke.from - longer);
        const float to = std::min(*(end - 1), stroke.to + longer);
        std::string path;
        addPoint(path, 'M', placeAt(yarn, from));
        for (auto a = std::upper_bound(begin, end, from); a != end && *a < to; ++a) {
            addPoint(path, 'L', curves.nodes[static_cast<std::size_t>(a - curves.arc.begin())]);
        }
        addPoint(path, 'L', placeAt(yarn, to));
        return path;
    }

    /// On the curve, at an arc length of its yarn.
    Vec3f placeAt(const geometry::YarnCurves::Range& yarn, float arc) const {
        const geometry::YarnCurves& curves = m_shape.curves;
        const auto begin = curves.arc.begin() + yarn.first;
        const auto next =
            std::clamp(std::upper_bound(begin, begin + yarn.count, arc), begin + 1, begin + yarn.count - 1);
        const auto n = static_cast<std::size_t>(next - curves.arc.begin());
        const float span = curves.arc[n] - curves.arc[n - 1];
        const float share = span > 0 ? std::clamp((arc - curves.arc[n - 1]) / span, 0.0F, 1.0F) : 0;
        return curves.nodes[n - 1] + share * (curves.nodes[n] - curves.nodes[n - 1]);
    }

    void addPoint(std::string& path, char command, const Vec3f& place) const {
        fmt::format_to(std::back_inserter(path), "{}{:.3f} {:.3f}", command,
                       (m_back ? -place.x() : place.x()) - m_left, -place.y() - m_top);
    }

    Output& m_out;
    const Shape& m_shape;
    bool m_back;
    float m_left = 0;
    float m_top = 0;
};

} // namespace

void writeSvg(Output& out, const Shape& shape, const WriteOptions& options) {
    Drawing(out, shape, options.back).write();
}

} // namespace knittsim::exports

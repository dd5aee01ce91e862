#include "core/export/writers.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace knittsim::exports {

namespace {

constexpr std::size_t kBetweenReports = 4096;

/// Names of materials end at a blank.
std::string materialName(std::size_t carrier, const Material& material) {
    std::string name = fmt::format("carrier{}", carrier + 1);
    if (!material.name.empty()) {
        name += '_' + material.name;
    }
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isspace(c) != 0 || std::iscntrl(c) != 0; }, '_');
    return name;
}

void writeMaterials(Output& out, const Shape& shape) {
    for (std::size_t c = 0; c < shape.materials.size(); ++c) {
        const Material& material = shape.materials[c];
        const auto [r, g, b] = material.colour;
        out.print("newmtl {}\nKd {:.4f} {:.4f} {:.4f}\nKs 0.04 0.04 0.04\nNs 12\nd 1\nillum 2\n\n",
                  materialName(c, material), r / 255.0, g / 255.0, b / 255.0);
    }
}

} // namespace

void writeObj(Output& out, Output& materials, const std::string& materialsName, const Shape& shape,
              const WriteOptions& options) {
    writeMaterials(materials, shape);
    out.print("# KnittSim: a tube for each yarn, millimetres\nmtllib {}\n", materialsName);
    std::size_t before = 0; // places of the yarns so far
    const auto nodes = static_cast<double>(std::max<std::size_t>(1, shape.curves.nodes.size()));
    for (std::size_t y = 0; y < shape.curves.yarns.size(); ++y) {
        const geometry::YarnCurves::Range& yarn = shape.curves.yarns[y];
        const Material& material = shape.materials[yarn.carrier];
        const geometry::TubeMesh tube = tubeOf(shape, yarn, options);
        std::size_t done = 0;
        const double total = static_cast<double>(2 * tube.places.size() + tube.triangles.size() / 3 + 1);
        const auto report = [&] {
            if (done++ % kBetweenReports == 0) {
                out.advance((yarn.first + yarn.count * (static_cast<double>(done) / total)) / nodes);
            }
        };
        out.print("o yarn{}\nusemtl {}\ns 1\n", y + 1, materialName(yarn.carrier, material));
        for (const Vec3f& p : tube.places) {
            report();
            out.print("v {:.5f} {:.5f} {:.5f}\n", p.x(), p.y(), p.z());
        }
        for (const Vec3f& n : tube.normals) {
            report();
            out.print("vn {:.4f} {:.4f} {:.4f}\n", n.x(), n.y(), n.z());
        }
        for (std::size_t t = 0; t < tube.triangles.size(); t += 3) {
            report();
            const std::size_t a = before + tube.triangles[t] + 1;
            const std::size_t b = before + tube.triangles[t + 1] + 1;
            const std::size_t c = before + tube.triangles[t + 2] + 1;
            out.print("f {}//{} {}//{} {}//{}\n", a, a, b, b, c, c);
        }
        before += tube.places.size();
    }
}

} // namespace knittsim::exports

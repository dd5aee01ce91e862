#include "core/export/base64.h"
#include "core/export/writers.h"
#include "core/geometry/bounds.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

namespace knittsim::exports {

namespace {

using nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr std::uint32_t kMagic = 0x46546C67; // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

/// Colours of light add up; those of a screen do not.
double linear(std::uint8_t value) {
    const double c = value / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

ordered_json triple(const Vec3f& v) {
    return {v.x(), v.y(), v.z()};
}

class Document {
public:
    Document(Output& out, const Shape& shape, const WriteOptions& options)
        : m_out(out), m_shape(shape), m_options(options) {
        for (const geometry::YarnCurves::Range& yarn : shape.curves.yarns) {
            m_carriers.insert(yarn.carrier);
        }
    }

    /// The description, once all tubes have been made to count them.
    void describe() {
        m_json["asset"] = {{"version", "2.0"}, {"generator", "KnittSim"}};
        m_json["scene"] = 0;
        m_json["scenes"] = {{{"name", "fabric"}, {"nodes", {0}}}};
        // Metres; the fabric itself is written in mm.
        m_json["nodes"] = {{{"name", "fabric"}, {"scale", {0.001, 0.001, 0.001}}}};
        for (const char* list : {"meshes", "materials", "accessors", "bufferViews"}) {
            m_json[list] = ordered_json::array();
        }
        for (const machine::CarrierIndex c : m_carriers) {
            const Material& material = m_shape.materials[c];
            const yarn::Colour colour = material.colour;
            m_json["materials"].push_back(
                {{"name", fmt::format("carrier {}: {}", c + 1, material.name)},
                 {"pbrMetallicRoughness",
                  {{"baseColorFactor", {linear(colour.r), linear(colour.g), linear(colour.b), 1.0}},
                   {"metallicFactor", 0.0},
                   {"roughnessFactor", 0.9}}}});
        }
        for (std::size_t y = 0; y < m_shape.curves.yarns.size(); ++y) {
            m_out.advance(0.3 * static_cast<double>(y) / static_cast<double>(m_shape.curves.yarns.size()));
            addYarn(y);
        }
        dropEmptyLists();
    }

    /// Without the buffer, and without the bracket at the end.
    std::string openText() const {
        std::string text = m_json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
        text.pop_back();
        return text;
    }
    std::size_t bufferBytes() const { return m_bytes; }

    /// Calls `put` with the bytes of the buffer, piece by piece.
    template<class Put> void forEachPiece(const Put& put) {
        for (std::size_t y = 0; y < m_shape.curves.yarns.size(); ++y) {
            const geometry::TubeMesh tube = tubeAt(y);
            putPieces(put, std::span(tube.places));
            putPieces(put, std::span(tube.normals));
            putPieces(put, std::span(tube.triangles));
        }
    }

private:
    geometry::TubeMesh tubeAt(std::size_t y) const {
        return tubeOf(m_shape, m_shape.curves.yarns[y], m_options);
    }

    auto materialOf(std::size_t y) const {
        return std::distance(m_carriers.begin(), m_carriers.find(m_shape.curves.yarns[y].carrier));
    }

    void addYarn(std::size_t y) {
        const geometry::TubeMesh tube = tubeAt(y);
        if (tube.places.empty()) {
            return; // an accessor has to have elements
        }
        const geometry::Bounds box = geometry::boundsOf(tube.places);
        const std::size_t places = addView(tube.places.size() * sizeof(Vec3f), kArrayBuffer);
        const std::size_t normals = addView(tube.normals.size() * sizeof(Vec3f), kArrayBuffer);
        const std::size_t corners =
            addView(tube.triangles.size() * sizeof(std::uint32_t), kElementArrayBuffer);
        ordered_json& accessors = m_json["accessors"];
        const std::size_t first = accessors.size();
        accessors.push_back({{"bufferView", places},
                             {"componentType", kFloat},
                             {"count", tube.places.size()},
                             {"type", "VEC3"},
                             {"min", triple(box.low)},
                             {"max", triple(box.high)}});
        accessors.push_back({{"bufferView", normals},
                             {"componentType", kFloat},
                             {"count", tube.normals.size()},
                             {"type", "VEC3"}});
        accessors.push_back({{"bufferView", corners},
                             {"componentType", kUnsignedInt},
                             {"count", tube.triangles.size()},
                             {"type", "SCALAR"}});
        const std::string name = fmt::format("yarn {}", y + 1);
        const std::size_t mesh = m_json["meshes"].size();
        m_json["meshes"].push_back({{"name", name},
                                    {"primitives",
                                     {{{"attributes", {{"POSITION", first}, {"NORMAL", first + 1}}},
                                       {"indices", first + 2},
                                       {"material", materialOf(y)}}}}});
        m_json["nodes"][0]["children"].push_back(m_json["nodes"].size());
        m_json["nodes"].push_back({{"name", name}, {"mesh", mesh}});
    }

    std::size_t addView(std::size_t bytes, int target) {
        m_json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", m_bytes}, {"byteLength", bytes}, {"target", target}});
        m_bytes += bytes; // all parts have 4 bytes: every view begins at a multiple of four
        return m_json["bufferViews"].size() - 1;
    }

    /// glTF knows no empty lists.
    void dropEmptyLists() {
        for (const char* list : {"meshes", "materials", "accessors", "bufferViews"}) {
            if (m_json[list].empty()) {
                m_json.erase(list);
            }
        }
    }

    template<class Put, class T> void putPieces(const Put& put, std::span<T> values) {
        constexpr std::size_t kPiece = 12288;
        for (std::size_t i = 0; i < values.size(); i += kPiece) {
            const auto part = values.subspan(i, std::min(kPiece, values.size() - i));
            m_put += part.size_bytes();
            m_out.advance(0.3 + 0.7 * static_cast<double>(m_put) / static_cast<double>(m_bytes));
            put(std::string_view(reinterpret_cast<const char*>(part.data()), part.size_bytes()));
        }
    }

    Output& m_out;
    const Shape& m_shape;
    const WriteOptions& m_options;
    std::set<machine::CarrierIndex> m_carriers; ///< that have yarn; one material each
    ordered_json m_json;
    std::size_t m_bytes = 0; ///< of the buffer
    std::size_t m_put = 0;
};

void writeBinary(Output& out, Document& document) {
    std::string text = document.openText();
    if (document.bufferBytes() > 0) {
        text += fmt::format(R"(,"buffers":[{{"byteLength":{}}}])", document.bufferBytes());
    }
    text += '}';
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto textBytes = static_cast<std::uint32_t>(text.size());
    const auto bufferBytes = static_cast<std::uint32_t>(document.bufferBytes());
    const bool withBuffer = bufferBytes > 0;
    const std::uint32_t total = 12 + 8 + textBytes + (withBuffer ? 8 + bufferBytes : 0);
    const std::array<std::uint32_t, 5> head{kMagic, 2, total, textBytes, kJsonChunk};
    out.writeRaw(std::span<const std::uint32_t>(head));
    out.write(text);
    if (withBuffer) {
        const std::array<std::uint32_t, 2> chunk{bufferBytes, kBinaryChunk};
        out.writeRaw(std::span<const std::uint32_t>(chunk));
        document.forEachPiece([&out](std::string_view bytes) { out.write(bytes); });
    }
}

void writeText(Output& out, Document& document) {
    out.write(document.openText());
    if (document.bufferBytes() > 0) {
        out.print(R"(,"buffers":[{{"byteLength":{},"uri":"data:application/octet-stream;base64,)",
                  document.bufferBytes());
        Base64 base64;
        document.forEachPiece([&](std::string_view bytes) { out.write(base64.put(bytes)); });
        out.write(base64.finish());
        out.write("\"}]");
    }
    out.write("}\n");
}

} // namespace

bool writeGltf(Output& out, const Shape& shape, const WriteOptions& options, bool binary) {
    Document document(out, shape, options);
    document.describe();
    // Room for the description, which has some hundred bytes for each yarn.
    constexpr std::size_t kMostBytes = (std::size_t{1} << 32) - (std::size_t{1} << 26);
    if (document.bufferBytes() > kMostBytes) {
        return false;
    }
    if (binary) {
        writeBinary(out, document);
    } else {
        writeText(out, document);
    }
    return true;
}

} // namespace knittsim::exports

#include "tests/support/read_gltf.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace knittsim::test {

namespace {

using nlohmann::json;

std::uint32_t number(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    if (at + sizeof value <= bytes.size()) {
        std::memcpy(&value, bytes.data() + at, sizeof value);
    }
    return value;
}

class Checker {
public:
    explicit Checker(GltfFile& file) : m_file(file), m_json(file.json) {}

    void check() {
        expect(m_json.value("/asset/version"_json_pointer, "") == "2.0", "asset.version is not 2.0");
        for (const auto& [key, list] : m_json.items()) {
            expect(!list.empty(), "empty " + key);
            expect(std::ranges::count(kKnown, key) == 1, "unknown " + key);
        }
        checkBuffers();
        checkNodes();
        for (const json& mesh : m_json.value("meshes", json::array())) {
            for (const json& primitive : mesh["primitives"]) {
                readPrimitive(primitive);
            }
        }
    }

private:
    static constexpr std::array<std::string_view, 9> kKnown{
        "asset", "scene", "scenes", "nodes", "meshes", "materials", "accessors", "bufferViews", "buffers"};

    void expect(bool fine, const std::string& fault) {
        if (!fine) {
            m_file.faults.push_back(fault);
        }
    }

    void checkBuffers() {
        const json buffers = m_json.value("buffers", json::array());
        expect(buffers.size() <= 1, "more than one buffer");
        const std::size_t bytes = buffers.empty() ? 0 : buffers[0]["byteLength"].get<std::size_t>();
        // The chunk may be up to three bytes longer.
        expect(m_file.buffer.size() >= bytes && m_file.buffer.size() < bytes + 4, "length of the buffer");
        std::size_t next = 0;
        for (const json& view : m_json.value("bufferViews", json::array())) {
            const std::size_t offset = view["byteOffset"];
            const std::size_t length = view["byteLength"];
            expect(view["buffer"] == 0, "buffer of a view");
            expect(offset % 4 == 0, "view not aligned");
            expect(length > 0 && offset + length <= bytes, "view outside the buffer");
            expect(offset >= next, "views overlap");
            expect(view["target"] == 34962 || view["target"] == 34963, "target of a view");
            next = offset + length;
        }
        expect(next == bytes, "bytes that nothing uses");
    }

    void checkNodes() {
        const std::size_t nodes = m_json["nodes"].size();
        std::vector<int> parents(nodes, 0);
        std::vector<bool> used(m_json.value("meshes", json::array()).size(), false);
        expect(m_json["scene"].get<std::size_t>() < m_json["scenes"].size(), "scene");
        const auto count = [&](const json& list) {
            for (const std::size_t child : list) {
                expect(child < nodes, "node that is not there");
                parents[std::min(child, nodes - 1)] += 1;
            }
        };
        for (const json& scene : m_json["scenes"]) {
            count(scene["nodes"]);
        }
        for (const json& node : m_json["nodes"]) {
            expect(!node.contains("children") || !node["children"].empty(), "empty children");
            count(node.value("children", json::array()));
            if (node.contains("mesh")) {
                expect(node["mesh"].get<std::size_t>() < used.size(), "mesh that is not there");
                used[std::min(node["mesh"].get<std::size_t>(), used.size() - 1)] = true;
            }
        }
        expect(std::ranges::all_of(parents, [](int n) { return n == 1; }), "a node has not one parent");
        expect(std::ranges::all_of(used, [](bool is) { return is; }), "a mesh is not shown");
    }

    /// Values of an accessor; `type` and `component` as the specification asks for here.
    template<class T>
    std::vector<T> values(std::size_t accessor, const char* type, int component, int target) {
        expect(accessor < m_json["accessors"].size(), "accessor that is not there");
        const json& a = m_json["accessors"].at(accessor);
        const json& view = m_json["bufferViews"].at(a["bufferView"].get<std::size_t>());
        const std::size_t count = a["count"];
        const std::size_t bytes = count * sizeof(T);
        expect(a["type"] == type && a["componentType"] == component, "type of an accessor");
        expect(view["target"] == target, "target of an accessor's view");
        expect(count > 0, "empty accessor");
        expect(bytes <= view["byteLength"].get<std::size_t>(), "accessor outside its view");
        std::vector<T> result(count);
        const std::size_t offset = view["byteOffset"];
        if (offset + bytes <= m_file.buffer.size()) {
            std::memcpy(static_cast<void*>(result.data()), m_file.buffer.data() + offset, bytes);
        }
        return result;
    }

    void readPrimitive(const json& primitive) {
        GltfMesh& mesh = m_file.meshes.emplace_back();
        Surface& surface = mesh.surface;
        const std::size_t places = primitive["attributes"]["POSITION"];
        surface.places = values<Vec3f>(places, "VEC3", 5126, 34962);
        surface.normals = values<Vec3f>(primitive["attributes"]["NORMAL"], "VEC3", 5126, 34962);
        surface.corners = values<std::uint32_t>(primitive["indices"], "SCALAR", 5125, 34963);
        expect(surface.places.size() == surface.normals.size(), "attributes of different length");
        expect(surface.corners.size() % 3 == 0, "corners are not triangles");
        expect(primitive.value("mode", 4) == 4, "mode");
        for (const Vec3f& normal : surface.normals) {
            expect(std::abs(normal.norm() - 1) < 5e-4F, "normal not of unit length");
        }
        for (const std::uint32_t corner : surface.corners) {
            expect(corner < surface.places.size(), "corner outside the mesh");
        }
        checkBounds(m_json["accessors"].at(places), surface.places);
        const std::size_t material = primitive["material"];
        expect(material < m_json["materials"].size(), "material that is not there");
        const json& pbr = m_json["materials"].at(material)["pbrMetallicRoughness"];
        mesh.colour = pbr["baseColorFactor"].get<std::array<double, 4>>();
        for (const double c : mesh.colour) {
            expect(c >= 0 && c <= 1, "colour");
        }
    }

    void checkBounds(const json& accessor, const std::vector<Vec3f>& places) {
        Vec3f low = places.front();
        Vec3f high = places.front();
        for (const Vec3f& place : places) {
            expect(place.allFinite(), "place that is not finite");
            low = low.cwiseMin(place);
            high = high.cwiseMax(place);
        }
        for (int c = 0; c < 3; ++c) {
            const auto i = static_cast<std::size_t>(c);
            expect(accessor["min"][i].get<float>() == low[c] && accessor["max"][i].get<float>() == high[c],
                   "min or max is not that of the values");
        }
    }

    GltfFile& m_file;
    json& m_json;
};

std::string fromBase64(std::string_view signs) {
    constexpr std::string_view kSigns = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t held = 0;
    int bits = 0;
    for (const char c : signs.substr(0, signs.find('='))) {
        held = held << 6 | static_cast<std::uint32_t>(kSigns.find(c));
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>(held >> bits & 0xFF);
        }
    }
    return bytes;
}

} // namespace

GltfFile readGlb(std::string_view bytes) {
    GltfFile file;
    const auto expect = [&](bool fine, const char* fault) {
        if (!fine) {
            file.faults.emplace_back(fault);
        }
    };
    expect(bytes.substr(0, 4) == "glTF" && number(bytes, 4) == 2, "magic or version");
    expect(number(bytes, 8) == bytes.size(), "length of the file");
    const std::uint32_t text = number(bytes, 12);
    expect(text % 4 == 0, "JSON chunk not padded");
    expect(bytes.substr(16, 4) == "JSON", "first chunk is not JSON");
    file.json = nlohmann::json::parse(bytes.substr(20, text));
    const std::size_t binary = 20 + std::size_t{text};
    if (binary < bytes.size()) {
        expect(number(bytes, binary) % 4 == 0, "binary chunk not padded");
        expect(bytes.substr(binary + 4, 4) == std::string_view("BIN\0", 4), "second chunk is not BIN");
        file.buffer = bytes.substr(binary + 8);
        expect(file.buffer.size() == number(bytes, binary), "length of the binary chunk");
    }
    Checker(file).check();
    return file;
}

GltfFile readGltf(std::string_view text) {
    GltfFile file;
    file.json = nlohmann::json::parse(text);
    if (file.json.contains("buffers")) {
        const std::string uri = file.json["buffers"][0]["uri"];
        file.buffer = fromBase64(std::string_view(uri).substr(uri.find(',') + 1));
    }
    Checker(file).check();
    return file;
}

} // namespace knittsim::test

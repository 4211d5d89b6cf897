/* The plain method as a native program that answers one line on stdin with one line on stdout, so that the benchmark can
 * take turns between it and the WebAssembly engines:
 *   load MESH_FILE DECAL_FILE         ->  ok
 *   bake SIZE                         ->  MILLISECONDS TEXELS
 *   project M00 .. M23 RX RY RZ       ->  MILLISECONDS TEXELS   (over the newest bake)
 * MESH_FILE: uint32 vertex count, uint32 index count, then positions, normals, UVs (floats) and indices (uint32).
 * DECAL_FILE: uint32 width, uint32 height, then RGBA. Little-endian, as this machine. */
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "plain_method.h"

namespace {

template <typename T>
std::vector<T> read_array(std::istream& in, std::size_t count) {
    std::vector<T> values(count);
    in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
    return values;
}

template <typename Work>
void time_and_print(Work work) {
    const auto start = std::chrono::steady_clock::now();
    const uint32_t texels = work();
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    std::printf("%.4f %u\n", elapsed.count(), texels);
    std::fflush(stdout);
}

struct Bench {
    std::vector<float> positions, normals, uvs, map_positions, map_normals;
    std::vector<uint32_t> indices;
    std::vector<uint8_t> decal, base, out;
    uint32_t decal_width = 0, decal_height = 0, size = 0;

    void load(const std::string& mesh_file, const std::string& decal_file) {
        std::ifstream mesh(mesh_file, std::ios::binary);
        const auto counts = read_array<uint32_t>(mesh, 2);
        positions = read_array<float>(mesh, counts[0] * std::size_t{3});
        normals = read_array<float>(mesh, counts[0] * std::size_t{3});
        uvs = read_array<float>(mesh, counts[0] * std::size_t{2});
        indices = read_array<uint32_t>(mesh, counts[1]);
        std::ifstream picture(decal_file, std::ios::binary);
        const auto sides = read_array<uint32_t>(picture, 2);
        decal_width = sides[0];
        decal_height = sides[1];
        decal = read_array<uint8_t>(picture, std::size_t{4} * decal_width * decal_height);
    }

    void resize(uint32_t new_size) {
        if (new_size == size) return;
        size = new_size;
        const std::size_t texels = static_cast<std::size_t>(size) * size;
        map_positions.assign(texels * 3, 0.0f);
        map_normals.assign(texels * 3, 0.0f);
        base.assign(texels * 4, 255);
        out.assign(texels * 4, 255);
    }
};

}  // namespace

int main() {
    Bench bench;
    std::string line;
    while (std::getline(std::cin, line)) {
        std::istringstream words(line);
        std::string command;
        words >> command;
        if (command == "load") {
            std::string mesh_file, decal_file;
            words >> mesh_file >> decal_file;
            bench.load(mesh_file, decal_file);
            std::printf("ok\n");
            std::fflush(stdout);
        } else if (command == "bake") {
            uint32_t size = 0;
            words >> size;
            bench.resize(size);
            time_and_print([&] {
                return plain_bake(bench.positions.data(), bench.normals.data(), bench.uvs.data(), bench.indices.data(),
                                  static_cast<uint32_t>(bench.indices.size()), size, bench.map_positions.data(),
                                  bench.map_normals.data());
            });
        } else if (command == "project") {
            float numbers[15];
            for (float& number : numbers) words >> number;
            time_and_print([&] {
                return plain_project(bench.map_positions.data(), bench.map_normals.data(), bench.size, numbers,
                                     numbers + 12, bench.decal.data(), bench.decal_width, bench.decal_height,
                                     bench.base.data(), bench.out.data());
            });
        } else {
            std::fprintf(stderr, "unknown command: %s\n", line.c_str());
            return 2;
        }
    }
    return 0;
}
